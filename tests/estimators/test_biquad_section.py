"""Filter sections as statements: the same numbers as the filter they describe."""

import numpy as np
import sympy as sp
from scipy import signal

from similitude.estimators.bessel import bessel_sections
from similitude.estimators.biquad_section import BIQUAD, biquad_fields, cascade


def test_a_cascade_of_sections_is_the_filter():
    sections = np.vstack([bessel_sections("high", 45, 0.01), bessel_sections("low", 90, 0.01)])
    lines = cascade(sp.Symbol("x", real=True), 4, "input", "out")
    values = {f"biquad_{i + 1}_{j}": x for i, row in enumerate(sections) for j, x in enumerate(row)}
    values |= {f"input_memory_{i}": 0.0 for i in range(8)}
    x = np.random.default_rng(1).standard_normal(40)
    out = []
    for now in x:
        values["x"] = now
        for line in lines:
            used = {s: values[s.name] for s in line.expression.free_symbols}
            values[line.target] = float(line.expression.subs(used))
        out.append(values["out"])

    assert np.allclose(out, signal.sosfilt(np.insert(sections, 3, 1.0, axis=1), x), atol=1e-12)


def test_each_section_has_its_numbers_and_says_whose_it_is():
    fields = biquad_fields(("high-pass", "low-pass"))

    assert [f.name for f in fields] == ["biquad_1", "biquad_2"]
    assert [f.size for f in fields] == [len(BIQUAD)] * 2
    assert "low-pass" in fields[1].meaning
