"""The small C files beside an exported estimator: its numbers, its self-test, an example of its use.

Invariant: numbers are printed so that they read back to the same bits.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from similitude.embedded.configuration import Numbers
from similitude.embedded.vectors import TYPES, Vectors
from similitude.program.library import Library

_CONFIG = """\
/* {name}_config.h: the numbers of this estimator. Exported by similitude; yours to change.
 *
{assumed}
 *
 * The self-test holds for these numbers; export again after changing them.
 */

#ifndef {upper}_CONFIG_H
#define {upper}_CONFIG_H

#include "{name}.h"

static const {name}_config {name}_numbers = {{
{fields}
}};

#endif
"""

_SELF_TEST_H = """\
/* {name}_self_test.h: does this build give the bits it must? Exported by similitude. */

#ifndef {upper}_SELF_TEST_H
#define {upper}_SELF_TEST_H

enum {{ {upper}_SELF_TEST_SAMPLES = {samples}, {upper}_SELF_TEST_WORDS = {words} }};

/* Words that differ from what the Python twin computed, 0 where all is well; first_sample, unless it is
 * null, is set to the number of the first sample that differs (the number of samples: the last state). */
unsigned long {name}_self_test(unsigned long *first_sample);

#endif
"""

_SELF_TEST = """\
/* {name}_self_test.c: steps through {name}_vectors.h and counts words that differ; in the middle the
 * state is saved, damaged, and restored. Exported by similitude; do not edit. */

#include "{name}.h"
#include "{name}_config.h"
#include "{name}_self_test.h"
#include "{name}_vectors.h"

typedef union {name}_word {{
    {name}_real value;
    {word} bits;
}} {name}_word;

static unsigned long {name}_differ(const {name}_real *values, const {word} *wanted, unsigned long n)
{{
    unsigned long i;
    unsigned long count = 0UL;
    for (i = 0UL; i < n; ++i) {{
        {name}_word now;
        now.value = values[i];
        if (now.bits != {upper}_READ(&wanted[i])) {{
            ++count;
        }}
    }}
    return count;
}}

/* 0 where a saved state comes back whole and a damaged one is refused. */
static unsigned long {name}_saving({name}_state *state)
{{
    unsigned char bytes[{upper}_SAVED_BYTES];
    {name}_state other;
    unsigned long wrong = 0UL;
    {name}_save(&{name}_numbers, state, bytes);
    bytes[11] = (unsigned char)(bytes[11] ^ 4u);
    if ({name}_restore(&{name}_numbers, &other, bytes) != (int){upper}_RESTARTED) {{
        ++wrong;
    }}
    bytes[11] = (unsigned char)(bytes[11] ^ 4u);
    if ({name}_restore(&{name}_numbers, state, bytes) != (int){upper}_OK) {{
        ++wrong;
    }}
    return wrong;
}}

unsigned long {name}_self_test(unsigned long *first_sample)
{{
    {name}_state state;
    unsigned long wrong = 0UL;
    unsigned long first = (unsigned long){upper}_SELF_TEST_SAMPLES + 1UL;
    unsigned long k;
    {name}_init(&{name}_numbers, &state);
    for (k = 0UL; k < (unsigned long){upper}_SELF_TEST_SAMPLES; ++k) {{
        {name}_sample sample;
        {name}_output output;
        {name}_real *const into = &sample.{first_field};
        unsigned long before = wrong;
        unsigned long i;
        int status;
        for (i = 0UL; i < {fields}UL; ++i) {{
            {name}_word word;
            word.bits = {upper}_READ(&{name}_samples[({fields}UL * k) + i]);
            into[i] = word.value;
        }}
        status = {name}_step(&{name}_numbers, &state, &sample{step_end}
        if (status != (int){upper}_READ_BYTE(&{name}_status_wanted[k])) {{
            ++wrong;
        }}
        wrong += {name}_differ(&output.{first_output}, &{name}_outputs[{outputs}UL * k], {outputs}UL);
        if (k == ((unsigned long){upper}_SELF_TEST_SAMPLES / 2UL)) {{
            wrong += {name}_saving(&state);
        }}
        if ((wrong != before) && (first > k)) {{
            first = k;
        }}
    }}
    wrong += {name}_differ(&state.{first_state}, {name}_last_state, {states}UL);
    if ((wrong != 0UL) && (first > k)) {{
        first = k;
    }}
    if (first_sample != (unsigned long *)0) {{
        *first_sample = first;
    }}
    return wrong;
}}
"""

_VECTORS = """\
/* {name}_vectors.h: samples (faults included) and the words that must follow. Exported by similitude.
 * Computed by the Python twin of the estimator, each operation in this type. */

#ifndef {upper}_VECTORS_H
#define {upper}_VECTORS_H

#include <stdint.h>

#if defined(__AVR__)
#include <avr/pgmspace.h>
#define {upper}_ROM PROGMEM
#define {upper}_READ(p) pgm_read_dword(p)
#define {upper}_READ_BYTE(p) pgm_read_byte(p)
#else
#define {upper}_ROM
#define {upper}_READ(p) (*(p))
#define {upper}_READ_BYTE(p) (*(p))
#endif

/* {samples_of} of each sample */
static const {word} {name}_samples[{n_samples}] {upper}_ROM = {{
{samples}
}};

static const uint8_t {name}_status_wanted[{n}] {upper}_ROM = {{
{status}
}};

/* {outputs_of} after each */
static const {word} {name}_outputs[{n_outputs}] {upper}_ROM = {{
{outputs}
}};

static const {word} {name}_last_state[{n_state}] {upper}_ROM = {{
{state}
}};

#endif
"""

EXAMPLE = """\
/* example_main.c: how {name} is used. It runs as it is, on a target or on a PC:
 *
 *   cc -std=c99 -O2 -ffp-contract=off -D{contract} example_main.c {name}.c {name}_self_test.c -o example
 *   ./example
 *
 * and ends with 0 where the self-test found no differing word and a drive could be estimated. */

#include "{name}.h"
#include "{name}_config.h"
#include "{name}_self_test.h"

static {name}_state state; /* {state_bytes} bytes, the only memory it needs between samples */

/* Put your sensors here. Where one has no new value, hand on NaN: the step knows what to do. */
static void read_sensors({name}_sample *sample)
{{
{reading}
}}

int main(void)
{{
    unsigned char kept[{upper}_SAVED_BYTES]; /* in your EEPROM or flash */
    int k;
    if ({name}_self_test((unsigned long *)0) != 0UL) {{
        return 1; /* this build does not give the bits it must: see README.md */
    }}
    {name}_init(&{name}_numbers, &state);
    for (k = 0; k < 1000; ++k) {{ /* once each {sample_time} s */
        {name}_sample sample;
        {name}_output output;
        int status;
        read_sensors(&sample);
        status = {name}_step(&{name}_numbers, &state, &sample{step_end}
        if (status == (int){upper}_BAD_SAMPLE) {{
            return 2; /* time did not advance */
        }}
    }}
    {name}_save(&{name}_numbers, &state, kept);
    if ({name}_restore(&{name}_numbers, &state, kept) != (int){upper}_OK) {{
        return 3; /* damaged: it begins anew from the prior */
    }}
    return 0;
}}
"""


def config_text(library: Library, numbers: Numbers, real: str) -> str:
    """``NAME_config.h``."""
    values = iter(numbers.values.astype(TYPES[real]))
    lines = []
    for name, unit, meaning, size in library.layout.CONFIG:
        taken = ", ".join(_number(next(values), real) for _ in range(size))
        text = f"{{{taken}}}" if size > 1 else taken
        lines.append(f"    /* {name} [{unit}] {meaning} */\n    {text},")
    assumed = "\n".join(f" *   {k} = {v:.9g} {u}   {o}" for k, (v, u, o) in numbers.assumed.items())
    text = "\n".join(lines).rstrip(",")
    return _CONFIG.format(name=library.name, upper=library.name.upper(), assumed=assumed, fields=text)


def _number(value: np.floating, real: str) -> str:
    text = np.format_float_scientific(value, unique=True, trim="0", exp_digits=2)
    return f"{text}f" if real == "float" else text


def self_test_texts(library: Library, vectors: Vectors, real: str) -> dict[str, str]:
    """``NAME_self_test.h``, ``NAME_self_test.c`` and ``NAME_vectors.h``."""
    name, layout = library.name, library.layout
    n, fields = vectors.samples.shape
    words = {
        "name": name,
        "upper": name.upper(),
        "word": "uint64_t" if real == "double" else "uint32_t",
        "n": n,
        "fields": fields,
        "outputs": vectors.outputs.shape[1],
        "states": vectors.state.size,
        "samples": n,
        "words": vectors.words,
        "first_field": layout.SAMPLE[0][0],
        "first_output": layout.OUTPUT[0][0],
        "first_state": _first(layout.STATE),
        "step_end": step_end(library),
    }
    listed = {
        **words,
        "n_samples": vectors.samples.size,
        "n_outputs": vectors.outputs.size,
        "n_state": vectors.state.size,
        "samples_of": ", ".join(row[0] for row in layout.SAMPLE),
        "outputs_of": ", ".join(row[0] for row in layout.OUTPUT),
        "samples": _table(vectors.samples, real),
        "status": "\n".join(
            "    " + ", ".join(map(str, vectors.status[i : i + 32])) + "," for i in range(0, n, 32)
        ),
        "outputs": _table(vectors.outputs, real),
        "state": _table(vectors.state[None], real),
    }
    return {
        f"{name}_self_test.h": _SELF_TEST_H.format(**words),
        f"{name}_self_test.c": _SELF_TEST.format(**words),
        f"{name}_vectors.h": _VECTORS.format(**listed),
    }


def step_end(library: Library) -> str:
    """How a call of a step ends: with the output, or with a call of the report that hands it out."""
    name = library.name
    if not library.layout.REPORTS:
        return ", &output);"
    return f");\n        {name}_report(&{name}_numbers, &state, &output);"


def _first(rows: tuple) -> str:
    name, _, _, size = rows[0]
    return f"{name}[0]" if size > 1 else name


def _table(bits: NDArray, real: str) -> str:
    digits, end = (16, "ULL") if real == "double" else (8, "UL")
    return "\n".join(
        "    " + ", ".join(f"0x{int(word):0{digits}X}{end}" for word in row) + "," for row in bits
    )


def example_text(
    library: Library, numbers: Numbers, real: str, *, contract: str, state_bytes: int, row: NDArray
) -> str:
    """``example_main.c``, with one believable sample."""
    reading = "\n".join(
        f"    sample->{field} = {_number(TYPES[real](value), real)}; /* [{unit}] {meaning} */"
        for (field, unit, meaning, _), value in zip(library.layout.SAMPLE, row, strict=True)
    )
    return EXAMPLE.format(
        name=library.name,
        upper=library.name.upper(),
        contract=contract,
        state_bytes=state_bytes,
        reading=reading,
        step_end=step_end(library),
        sample_time=f"{numbers.sample_time:g}",
    )
