// Draws the charts of the page with uPlot: shared zoom and cursor, live legend, light and dark, paper.
(function () {
  "use strict";
  const root = document.documentElement;
  const data = JSON.parse(document.getElementById("data").textContent);
  const live = [];   // one {name, spec, box, legend, plot, hidden} for each chart on the page
  const zoom = {};   // name of a group of charts -> [from, to]; missing where all of x is shown
  const PAPER = { width: 700, sharp: 3 };  // pixels of a page's width, and how many make one of them

  const colour = name => getComputedStyle(root).getPropertyValue("--" + name).trim();
  const group = chart => chart.spec.sync || "alone " + chart.name;
  const unit = text => (text ? " " + text : "");

  function number(value) {
    if (value == null) return "–";
    const size = Math.abs(value);
    const text = size !== 0 && (size < 1e-4 || size >= 1e7) ? value.toExponential(2) : String(+value.toPrecision(4));
    return text.replace("-", "−");
  }

  // Columns as uPlot wants them: one x for all, undefined where a series has no point of its own.
  function columns(spec) {
    const own = [...spec.bands.map(b => [b.x, b.upper, b.lower]), ...spec.lines.map(l => [l.x, l.y])];
    return own.length > 1 ? uPlot.join(own) : own[0];
  }

  function series(chart, k) {
    const edges = chart.spec.bands.flatMap(() => [edge(), edge()]);
    return [{}, ...edges, ...chart.spec.lines.map(line => stroke(line, k))]
      .map((one, i) => (chart.hidden.has(i) ? { ...one, show: false } : one));
  }

  function edge() {
    return { width: 0, stroke: "transparent", points: { show: false } };
  }

  function stroke(line, k) {
    const ink = colour(line.colour);
    const one = { label: line.label, stroke: ink, width: line.width * k, points: { size: 4 * k, width: k, fill: ink } };
    if (line.dashed) one.dash = [6 * k, 4 * k];
    if (line.dashed) one.points.show = false;
    if (line.kind === "points") { one.paths = () => null; one.points.show = true; }
    if (line.kind === "bars") {
      one.paths = uPlot.paths.bars({ size: [0.8, 60 * k] });
      one.fill = ink;
      one.points.show = false;
    }
    return one;
  }

  function bands(spec) {
    return spec.bands.map((band, i) => ({ series: [1 + 2 * i, 2 + 2 * i], fill: faint(band.colour, 0.24) }));
  }

  function faint(name, share) {
    const hex = colour(name).slice(1);
    const [r, g, b] = [0, 2, 4].map(at => parseInt(hex.slice(at, at + 2), 16));
    return `rgba(${r},${g},${b},${share})`;
  }

  // 1-2-5 steps as plain numbers, finer where the axis spans little.
  function logTicks(low, high) {
    let ticks = [];
    for (const steps of [[1, 2, 3, 4, 5, 6, 8], [1, 2, 3, 5], [1, 2, 5], [1, 3], [1]]) {
      ticks = [];
      for (let p = Math.floor(Math.log10(low)); p <= Math.ceil(Math.log10(high)); p++)
        for (const step of steps) ticks.push(step * 10 ** p);
      ticks = ticks.filter(tick => tick >= low && tick <= high);
      if (ticks.length <= 7) break;
    }
    return ticks.length > 1 ? ticks : [low, Math.sqrt(low * high), high];
  }

  function yScale(chart) {
    const { spec } = chart;
    const around = (low, high) => {
      if (spec.y_range && !zoom[group(chart)]) return spec.y_range;
      if (low == null) return spec.y_range || [1, 2];
      return spec.log ? [low / 1.08, high * 1.08] : uPlot.rangeNum(low, high, 0.1, true);
    };
    return { distr: spec.log ? 3 : 1, range: (_, low, high) => around(low, high) };
  }

  function xScale(chart, onPaper) {
    const [first, last] = chart.spec.x_range;
    const room = chart.spec.lines.some(line => line.kind === "bars") ? 0.02 * (last - first) : 0;
    const drawn = columns(chart.spec)[0];  // may begin after the first sample: extremes stand for it
    const range = (_, from, to) => {
      const all = from == null || (from <= drawn[0] && to >= drawn[drawn.length - 1]);
      if (onPaper) return [first - room, last + room];
      // Here, before the y axes are ranged: they ask whether the chart is zoomed.
      if (all) delete zoom[group(chart)]; else zoom[group(chart)] = [from, to];
      return all ? [first - room, last + room] : [from, to];
    };
    return { time: false, range };
  }

  function axes(spec, k) {
    const look = {
      stroke: colour("muted"), font: `${11 * k}px system-ui, sans-serif`, gap: 4 * k,
      grid: { stroke: colour("rule"), width: k }, ticks: { stroke: colour("rule"), width: k, size: 4 * k },
    };
    const x = {
      ...look, size: 24 * k, space: 60 * k, values: (_, ticks) => ticks.map(number),
      label: spec.x_label + (spec.x_unit ? ` [${spec.x_unit}]` : ""), labelSize: 16 * k, labelGap: 0,
      labelFont: `${11 * k}px system-ui, sans-serif`, grid: { show: false },
    };
    const y = { ...look, size: 52 * k, space: Math.min(30, spec.height / 6) * k, values: (_, ticks) => ticks.map(number) };
    if (spec.log) {
      y.splits = (_, axis, low, high) => logTicks(low, high);
      y.filter = (_, ticks) => ticks;
    }
    return [x, y];
  }

  function tint(spans) {
    return plot => {
      const { ctx, bbox } = plot;
      ctx.save();
      for (const [start, end, name, share] of spans) {
        const from = Math.max(plot.valToPos(start, "x", true), bbox.left);
        const to = Math.min(plot.valToPos(end, "x", true), bbox.left + bbox.width);
        if (to <= from) continue;
        ctx.fillStyle = faint(name, 0.08 + 0.22 * share);
        ctx.fillRect(from, bbox.top, Math.max(to - from, 1), bbox.height);
      }
      ctx.restore();
    };
  }

  // The nearest point a series has itself: lines of one chart keep different samples.
  function nearest(plot, i, hovered) {
    const values = plot.data[i];
    if (values[hovered] !== undefined) return hovered;
    for (let away = 1; away < values.length; away++) {
      if (values[hovered - away] !== undefined && hovered >= away) return hovered - away;
      if (values[hovered + away] !== undefined) return hovered + away;
    }
    return hovered;
  }

  function options(chart, width, k, onPaper) {
    const { spec } = chart;
    return {
      width: width * k, height: spec.height * k, legend: { show: false }, padding: [8 * k, 10 * k, 0, 0],
      series: series(chart, k), bands: bands(spec), axes: axes(spec, k),
      scales: { x: xScale(chart, onPaper), y: yScale(chart) },
      cursor: onPaper ? { show: false } : {
        y: false, drag: { x: true, y: false }, points: { size: 6 }, dataIdx: nearest,
        sync: spec.sync ? { key: spec.sync, setSeries: false, scales: ["x", null] } : undefined,
      },
      hooks: {
        drawClear: [tint(data.spans[spec.spans])],
        setCursor: onPaper ? [] : [plot => tell(chart, plot)],
        setScale: onPaper ? [] : [(plot, key) => { if (key === "x") follow(chart, plot); }],
      },
    };
  }

  function follow(chart, plot) {
    const { min, max } = plot.scales.x;
    for (const other of live) {
      if (other === chart || !other.plot || group(other) !== group(chart)) continue;
      const shown = other.plot.scales.x;
      if (shown.min !== min || shown.max !== max) other.plot.setScale("x", { min, max });
    }
    document.getElementById("reset").hidden = Object.keys(zoom).length === 0;
  }

  function draw(chart) {
    const kept = zoom[group(chart)];
    if (chart.plot) chart.plot.destroy();
    chart.plot = new uPlot(options(chart, chart.box.clientWidth, 1, false), columns(chart.spec), chart.box);
    if (kept) chart.plot.setScale("x", { min: kept[0], max: kept[1] });
    explain(chart);
  }

  function swatch(name, isArea) {
    const mark = document.createElement("i");
    mark.style.background = colour(name);
    if (isArea) mark.className = "area";
    return mark;
  }

  function entry(chart, drawn, isArea, columnsOfIt) {
    const button = document.createElement("button");
    button.hidden = !drawn.label;
    button.type = "button";
    button.title = "show or hide";
    button.setAttribute("aria-pressed", String(!chart.hidden.has(columnsOfIt[0])));
    button.append(swatch(drawn.colour, isArea), drawn.label, document.createElement("output"));
    button.addEventListener("click", () => {
      for (const i of columnsOfIt) if (!chart.hidden.delete(i)) chart.hidden.add(i);
      draw(chart);
    });
    return button;
  }

  function explain(chart) {
    const { spec, legend } = chart;
    const when = document.createElement("span");
    when.append(document.createElement("output"));
    const areas = spec.bands.map((band, i) => entry(chart, band, true, [1 + 2 * i, 2 + 2 * i]));
    const first = 1 + 2 * spec.bands.length;
    const lines = spec.lines.map((line, i) => entry(chart, line, false, [first + i]));
    const spans = Object.entries(spec.span_labels).map(([name, words]) => {
      const item = document.createElement("span");
      item.append(swatch(name, true), words);
      return item;
    });
    legend.replaceChildren(...lines, ...areas, ...spans, when);
  }

  // Values under the cursor, in the legend.
  function tell(chart, plot) {
    const outputs = chart.legend.querySelectorAll("output");
    if (!outputs.length) return;
    const { spec } = chart;
    const { idx, idxs } = plot.cursor;
    const at = i => (idx == null ? null : plot.data[i][idxs[i] == null ? idx : idxs[i]]);
    const first = 1 + 2 * spec.bands.length;
    const said = value => (value == null ? "" : number(value) + unit(spec.unit));
    spec.lines.forEach((_, i) => { outputs[i].textContent = said(at(first + i)); });
    spec.bands.forEach((_, i) => {
      const [high, low] = [at(1 + 2 * i), at(2 + 2 * i)];
      outputs[spec.lines.length + i].textContent = low == null ? "" : `${number(low)} … ${said(high)}`;
    });
    const x = idx == null ? null : plot.posToVal(plot.cursor.left, "x");
    outputs[outputs.length - 1].textContent = x == null ? "" : `${spec.x_label} ${number(x)}${unit(spec.x_unit)}`;
  }

  // Paper is light and sharper than the screen: each chart is drawn once more, whole, for it.
  function toPaper() {
    const theme = root.dataset.theme;
    root.dataset.theme = "light";
    for (const chart of live) {
      const place = document.createElement("div");
      const zoomed = zoom[group(chart)];
      delete zoom[group(chart)];
      const k = PAPER.sharp / Math.max(devicePixelRatio, 1);
      const plot = new uPlot(options(chart, PAPER.width, k, true), columns(chart.spec), place);
      plot.ctx.canvas.className = "paper";
      plot.ctx.canvas.removeAttribute("style");
      chart.box.after(plot.ctx.canvas);
      queueMicrotask(() => { if (zoomed) zoom[group(chart)] = zoomed; });
    }
    swatches();
    if (theme) root.dataset.theme = theme; else delete root.dataset.theme;
  }

  function fromPaper() {
    for (const canvas of document.querySelectorAll("canvas.paper")) canvas.remove();
    swatches();
  }

  function swatches() {
    for (const chart of live) {
      const names = [...chart.spec.lines, ...chart.spec.bands].map(one => one.colour);
      names.push(...Object.keys(chart.spec.span_labels));
      chart.legend.querySelectorAll("i").forEach((mark, i) => { mark.style.background = colour(names[i]); });
    }
  }

  function isDark() {
    return colour("ground") !== "#ffffff";
  }

  function switchTheme() {
    const wanted = isDark() ? "light" : "dark";
    const system = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
    root.dataset.theme = wanted;
    try {  // a choice that is the system's own is not kept: the page follows the system again
      if (wanted === system) localStorage.removeItem("similitude-theme");
      else localStorage.setItem("similitude-theme", wanted);
    } catch (fault) { /* a browser that keeps nothing still shows what was asked for */ }
    repaint();
  }

  function repaint() {
    document.getElementById("theme").textContent = isDark() ? "light" : "dark";
    live.forEach(draw);
  }

  for (const [name, spec] of Object.entries(data.charts)) {
    const place = document.getElementById("chart-" + name);
    const box = place.querySelector(".plot");
    box.setAttribute("role", "img");
    box.setAttribute("aria-label", `${spec.title}: ${spec.y_label} over ${spec.x_label}`);
    live.push({ name, spec, box, legend: place.querySelector(".legend"), plot: null, hidden: new Set() });
  }
  for (const chart of live) {  // charts that zoom together show the same whole, also those of fewer samples
    const ranges = live.filter(other => group(other) === group(chart)).map(other => other.spec.x_range);
    chart.spec.x_range = [Math.min(...ranges.map(one => one[0])), Math.max(...ranges.map(one => one[1]))];
  }
  repaint();
  new ResizeObserver(() => {
    for (const { plot, box, spec } of live)
      if (box.clientWidth && plot.width !== box.clientWidth) plot.setSize({ width: box.clientWidth, height: spec.height });
  }).observe(document.querySelector("main"));
  document.getElementById("theme").addEventListener("click", switchTheme);
  document.getElementById("reset").addEventListener("click", () => {
    for (const { plot, spec } of live) plot.setScale("x", { min: spec.x_range[0], max: spec.x_range[1] });
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", repaint);
  addEventListener("beforeprint", toPaper);
  addEventListener("afterprint", fromPaper);
})();
