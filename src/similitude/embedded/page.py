"""README.md of an exported folder: what it is, how to build it, what it costs, how to prove it.

Invariant: every command on the page can be pasted as it stands, from inside the folder.
"""

from __future__ import annotations

from similitude.embedded.machine import compile_line, emulator
from similitude.embedded.targets import CONTRACT_OFF, SECTIONS, STRICT, Target, flags_of
from similitude.program.library import Library

_PAGE = """\
# {name}

{title}. Exported by similitude from {system}: estimator `{estimator}`,
reals `{real}`, target `{target}` ({words}).

| File | What it is |
|---|---|
| `{name}.h` | the contract, the structs, {functions} functions; read this first |
| `{name}.c` | the estimator; the step is the same text that runs on a PC |
| `{name}_config.h` | its numbers, with units; yours to change |
| `{name}_self_test.c`, `.h`, `{name}_vectors.h` | {samples} samples with faults, and {compared} words |
| `example_main.c` | how it is used, start to finish |
{emulated_row}| `evidence.json` | target, cost, numbers taken, SHA-256 of each file |

## Use

```c
static {name}_state state;
{name}_init(&{name}_numbers, &state);                                  /* once */
status = {name}_step(&{name}_numbers, &state, &sample{step_end}        /* each {sample_time} s */
{report}```

| Goes in | Unit | Meaning |
|---|---|---|
{sample_rows}

{missing}

| Comes out | Unit | Meaning |
|---|---|---|
{output_rows}

What comes out is finite whatever went in. The status says what the sample was good for:

{status_rows}

## Build

```
{build}
```

Warnings it is free of: `{strict}`.
{bits}

## Prove it

On a PC, with its compiler; ends with 0 where no word differs:

```
cc -std=c99 -O2 -ffp-contract=off -D{contract} example_main.c {name}.c {name}_self_test.c -o example
./example
```

or, at three optimisation levels and with the warnings as errors, `similitude export --verify .`
{on_board}
On your own board call `{name}_self_test(0)` once: it returns the number of words that differ, 0.

## Cost

{cost}

## Numbers

{numbers}

{where}
"""

_REPORT = """\
{name}_report(&{name}_numbers, &state, &output);                        /* when you want to know */
"""
_MISSING = {
    "reals": "A value that is not there goes in as NaN.",
    "integers": """\
A field of format Qf is the value times 2^f, to the nearest (`{upper}_ESTIMATE_BITS` and so on); beyond
the format, its end. A value that is not there goes in as `{upper}_MISSING`.""",
}
_BITS = {
    "reals": """\
Never `-ffast-math`; where the processor can fuse multiply and add, `{name}.c` refuses to compile until
`-D{contract}` states that `-ffp-contract=off` is among the flags: with fusing, the bits would differ.""",
    "integers": """\
The flags about floating point are for the rest of your firmware: in here are whole numbers only. Their
formats hold what the gates let in and saturate beyond; no value wraps, whatever comes in.""",
}
_WHERE = {
    "reals": """\
All are in `{name}_config.h`, in SI units. The self-test holds for those that were exported: after a
change, run `similitude export` again.""",
    "integers": """\
They are literals of `{name}.c`, and the formats follow from them (`{name}_config.h` lists all): to
change one, run `similitude export` again.""",
}
_ROUNDING = {
    "reals": "rounding in them is\n{rounding:.1g} of the sensor's noise behind them.",
    "integers": "rounding in the whole\nstep moves the innovation by {rounding:.1g} of the sensor's noise.",
}

_COST = """\
| On {target}, {level}, {real} | |
|---|---:|
| {unit} a sample, mean over the self-test | {mean} |
| {unit} a sample, most | {most} |
{asked}| code of the step{and_report} | {step} B |
| code of init | {init} B |
| configuration (read only) | {numbers} B |
| **flash: step, init, configuration** | **{flash} B** |
| save and restore, where they are used | {saving} B |
| the compiler's arithmetic, shared with all code that uses it | {arithmetic} B |
| **RAM: the state** | **{state} B** |
| stack of a step, measured, arithmetic included | {stack} B |
| words of {samples} samples that differ from the twin | {differing} |

Measured by {compiler} and {emulator} when this folder was written. {what}"""

_ASKED = "| {unit} of a report, most, where one is asked for | {report} |\n"
_INSTRUCTIONS = """One instruction is one that the
emulated core retired, counted from before the call of the step to after its return, an empty call subtracted;
wait states and stalls of a real part are not in it."""
_CYCLES = """Cycles are those of the emulated core
from before the call of the step to after its return."""

_ON_QEMU = """
On the emulated {target} ({packages}):

```
cd emulated
{compile}
{emulate}
```

prints what differs and what a step costs, over the same samples.
"""
_ON_SIMAVR = """
On the emulated {target} ({packages}):

```
cd emulated
{compile}
cc -O2 simulate_avr.c -o simulate_avr -lsimavr -lelf
./simulate_avr firmware.elf {sizes}
```

prints what a step costs, over the same samples.
"""


def page_text(told: dict, library: Library, target: Target) -> str:
    """The page of a folder.

    Parameters
    ----------
    told : what the manifest says.
    library : layout of the estimator.
    """
    from similitude.status import MEANING

    layout, name = library.layout, library.name
    status = "\n".join(
        f"- `{name.upper()}_{key.upper()}` = {code}: {MEANING[key]}" for key, code in layout.STATUS.items()
    )
    title = layout.__doc__.splitlines()[0].split(": layout")[0]
    build = [target.compiler, *_shown(target), *STRICT, "-c", f"{name}.c", "-o", f"{name}.o"]
    emulated = target.name != "host"
    words = {"name": name, "upper": name.upper(), "contract": CONTRACT_OFF}
    kind = _kind(told)
    return _PAGE.format(
        missing=_MISSING[kind].format(**words),
        bits=_BITS[kind].format(**words),
        where=_WHERE[kind].format(**words),
        name=name,
        title=title[0].upper() + title[1:],
        system=told["system"],
        estimator=told["estimator"],
        real=told["real"],
        target=target.name,
        words=target.words,
        samples=told["self_test"]["samples"],
        compared=told["self_test"]["words"],
        emulated_row="| `emulated/` | the harness that measured the cost on an emulated board |\n"
        if emulated
        else "",
        step_end=");        " if layout.REPORTS else ", &output);",
        report=_REPORT.format(name=name) if layout.REPORTS else "",
        functions="six" if layout.REPORTS else "five",
        sample_time=f"{told['assumed']['sample_time']['value']:g}",
        sample_rows=_rows(layout.SAMPLE),
        output_rows=_rows(layout.OUTPUT),
        status_rows=status,
        build=" ".join(build),
        strict=" ".join(STRICT),
        contract=CONTRACT_OFF,
        on_board=_on_board(told, library, target) if emulated else "",
        cost=_cost(told, target),
        numbers=_numbers(told),
    )


def _kind(told: dict) -> str:
    return "integers" if told["real"] == "fixed" else "reals"


def _shown(target: Target) -> list[str]:
    return [flag for flag in flags_of(target) if target.name != "host" or flag not in SECTIONS]


def _rows(fields: tuple) -> str:
    return "\n".join(f"| `{name}` | {unit} | {meaning} |" for name, unit, meaning, _ in fields)


def _on_board(told: dict, library: Library, target: Target) -> str:
    words = {
        "target": target.name,
        "packages": f"on Debian: `apt-get install {target.packages}`",
        "compile": " ".join(compile_line(library.name, target)),
    }
    if target.name == "avr":
        sizes = (len(library.layout.SAMPLE), len(library.layout.OUTPUT), told["state_reals"])
        return _ON_SIMAVR.format(**words, sizes=" ".join(str(4 * size) for size in sizes))
    return _ON_QEMU.format(**words, emulate=" ".join([*emulator(target), "firmware.elf"]))


def _cost(told: dict, target: Target) -> str:
    cost = told["cost"]
    size = 8 if told["real"] == "double" else 4
    if cost is not None:
        emulator = "simavr" if target.name == "avr" else f"QEMU ({' '.join(target.machine[1:])})"
        what = _CYCLES if target.name == "avr" else _INSTRUCTIONS
        asked = _ASKED.format(**cost) if cost["report"] else ""
        and_report = " and the report" if asked else ""
        return _COST.format(**cost, emulator=emulator, what=what, asked=asked, and_report=and_report)
    state = f"The state takes {size * told['state_reals']} B of RAM."
    if target.name == "host":
        return f"{state} Time, flash and stack are measured on microcontrollers: another `--target`."
    return (
        f"{state} The rest was not measured: this machine lacked {', '.join(told['missing'])}. "
        f"On Debian `apt-get install {target.packages}`, then run the same `similitude export` again."
    )


def _numbers(told: dict) -> str:
    lines = "\n".join(
        f"- `{name}` = {value['value']:.6g} {value['unit']} ({value['from']})"
        for name, value in told["assumed"].items()
    )
    found = told["filters"]
    if found is None:
        return lines
    rounding = _ROUNDING[_kind(told)].format(**found)
    return (
        f"{lines}\n\nThe filters, rounded to `{told['real']}`, have poles up to {found['pole_radius']:.6f}; "
        + rounding
    )
