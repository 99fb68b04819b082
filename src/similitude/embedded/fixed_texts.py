"""The files of an export in fixed point: header, C file, numbers, example, and the words of the self-test.

Invariant: as for reals, the step is the generator's text cut out, and the words come from the twin.
"""

from __future__ import annotations

import hashlib
import re

import numpy as np
from numpy.typing import NDArray

from similitude.embedded.drive import self_test_rows
from similitude.embedded.fixed_profile import Profile
from similitude.embedded.source import SAVING, cut
from similitude.embedded.targets import CONTRACT_OFF
from similitude.embedded.texts import EXAMPLE, self_test_texts, step_end
from similitude.embedded.vectors import Vectors
from similitude.program.fixed.formats import MISSING
from similitude.program.fixed.integer import NARROW

_HEADER = """\
/* {name}.h: {title}. Exported by similitude {version}; do not edit.
 *
{provenance}
 *
 * Contract
 *   Language   C99, freestanding: includes <stdint.h>, calls compiler arithmetic alone. No heap, no libm.
 *   Memory     no globals. The caller owns the state: {states} words, {state_bytes} bytes.
 *   Time       bounded: a step has no loop and at most {most} operations; saving and restoring loop a
 *              constant number of times.
 *   Names      every symbol begins with {name}_.
 *   Integers   a field of format Qf is value 2^f, to the nearest. The ranges below follow from what the gates
 *              let in, from the l1 norms of the filters and from the population; what could leave them
 *              saturates. No value wraps, whatever comes in.
 *   Samples    any bits may come in; {upper}_MISSING is a value that is not there. A sample that cannot be
 *              used changes the status, never the ability to use the next one.
 *   Status     the names of the Python package: {names}.
 *   Bits       whole numbers: the same on every target that shifts negative values arithmetically, which is
 *              checked when compiled.
 *   Order      init (or restore), then one step a sample. A step of one state is not to be interrupted
 *              by another of the same state; different states are independent.
 */

#ifndef {guard}
#define {guard}

#include <stdint.h>

#ifdef __cplusplus
extern "C" {{
#endif

typedef int32_t {name}_real; /* a word; its format stands beside each field */

{declarations}
#define {upper}_MISSING (-INT32_C(2147483647) - 1) /* goes in where there is no value */

/* Bits behind the point: field = value 2^bits. */
enum {{
{fractions}
}};

/* Bytes of a saved state: what it is, for which configuration, the state, a checksum. */
enum {{ {upper}_SAVED_BYTES = {saved} }};

/* The state before the first sample: the prior. */
void {name}_init(const {name}_config *config, {name}_state *state);

/* One sample: returns a status. */
int {name}_step(const {name}_config *config, {name}_state *state,
                const {name}_sample *sample, {name}_output *output);

/* The state as {upper}_SAVED_BYTES bytes, in this processor's order. */
void {name}_save(const {name}_config *config, const {name}_state *state, unsigned char *bytes);

/* The state out of saved bytes, whole or not at all: {upper}_OK, or {upper}_RESTARTED where they are
 * damaged or belong to another version or configuration; the state is then that of init. */
int {name}_restore(const {name}_config *config, {name}_state *state, const unsigned char *bytes);

#ifdef __cplusplus
}}
#endif

#endif
"""

_SOURCE = """\
/* {name}.c: {title}. Exported by similitude {version}; do not edit.
 *
 * Operations: step {most} at most, {least} at least (arithmetic, comparisons, selects).
 * The contract is in {name}.h.
 */

#include "{name}.h"

#define SIMILITUDE_API
#define SIMILITUDE_INLINE static inline

{bodies}
SIMILITUDE_API int {name}_step(const {name}_config *config, {name}_state *state,
                               const {name}_sample *sample, {name}_output *output)
{{
    return {name}_advance(config, state, sample, output);
}}

"""

_CONFIG = """\
/* {name}_config.h: the numbers this estimator was made for. Exported by similitude.
 *
{assumed}
 *
 * They are literals of {name}.c, and the formats in {name}.h follow from them: to change one, export
 * again. A state saved for other numbers is not restored. All of them, in SI units:
 *
{listed}
 */

#ifndef {upper}_CONFIG_H
#define {upper}_CONFIG_H

#include "{name}.h"

static const {name}_config {name}_numbers = {{
    /* which numbers these are */
    {value}
}};

#endif
"""
_NAN = "hand on NaN: the step knows what to do."


def fixed_texts(profile: Profile, version: str) -> tuple[dict[str, str], Vectors]:
    """All C files of a folder by name, and the words of its self-test."""
    source, name = profile.source, profile.source.name
    library = source.library()
    rows = integer_rows(profile, self_test_drive(profile))
    vectors = expected_words(profile, rows)
    words = _words(profile, version, len(library.names("state")))
    reading = "\n".join(
        f"    sample->{f.name} = {_number(value)}; /* [{f.unit}] {f.meaning}: {value * f.format.step:.6g} */"
        for f, value in zip(profile.fixed.sample, rows[20].tolist(), strict=True)
    )
    example = EXAMPLE.replace(_NAN, "hand on {upper}_MISSING.").format(
        **words,
        contract=CONTRACT_OFF,
        reading=reading,
        step_end=step_end(library),
        sample_time=f"{profile.numbers.sample_time:g}",
    )
    texts = {
        f"{name}.h": _HEADER.format(**words),
        f"{name}.c": (_SOURCE + SAVING).format(**words),
        f"{name}_config.h": _config_text(profile),
        **self_test_texts(library, vectors, "fixed"),
        "example_main.c": example,
    }
    return texts, vectors


def self_test_drive(profile: Profile) -> NDArray[np.float64]:
    """Rows (n, sample fields) of the self-test in SI units: that of reals, turning harder.

    The gate of the output is narrower here, and the rows are made for it; a dead zone is to be left.
    """
    library, step = profile.plain.library(), profile.numbers.sample_time
    rows = self_test_rows(profile.plain, library, profile.config, step)
    rows[:, -1] *= HARDER
    return rows


HARDER = 4.0


def _words(profile: Profile, version: str, states: int) -> dict:
    source, name = profile.source, profile.source.name
    parts = cut(source.c, name)
    counts = re.search(r"step (\d+) at most, (\d+) at least", parts.head)
    told = re.search(r"do not edit\.\n \*\n(.*?)\n \*\n \* Operations", parts.head, re.S)
    fields = (*profile.fixed.sample, *profile.fixed.output)
    rows = [f"    {name.upper()}_{f.name.upper()}_BITS = {f.format.fraction}" for f in fields]
    return {
        "name": name,
        "upper": name.upper(),
        "guard": f"{name.upper()}_H",
        "title": re.match(r"/\* (.*?)\. Generated", parts.head).group(1),
        "provenance": told.group(1),
        "most": counts.group(1),
        "least": counts.group(2),
        "version": version,
        "states": states,
        "state_bytes": 4 * states,
        "saved": 12 + 4 * states,
        "names": ", ".join(profile.fixed.program.status),
        "declarations": parts.declarations,
        "bodies": parts.bodies,
        "fractions": ",\n".join(rows),
        "version_word": int(hashlib.sha256(("fixed" + parts.declarations).encode()).hexdigest()[:8], 16),
    }


def _config_text(profile: Profile) -> str:
    name = profile.source.name
    numbers = profile.numbers
    units = {s.name: f.unit for f in profile.fixed.program.config for s in f.symbols}
    names = profile.plain.library().names("config")
    listed = [f" *   {n} = {v:.9g} {units[n]}" for n, v in zip(names, profile.config.tolist(), strict=True)]
    return _CONFIG.format(
        name=name,
        upper=name.upper(),
        assumed="\n".join(f" *   {k} = {v:.9g} {u}   {o}" for k, (v, u, o) in numbers.assumed.items()),
        listed="\n".join(listed),
        value=_number(int(numbers.values[0])),
    )


def _number(value: int) -> str:
    if value == NARROW[0]:
        return "(-INT32_C(2147483647) - 1)"
    return f"INT32_C({value})" if value >= 0 else f"-INT32_C({-value})"


def integer_rows(profile: Profile, rows: NDArray) -> NDArray[np.int32]:
    """Samples in SI units as words: a missing value for what is not finite, the end of the format beyond it.

    Parameters
    ----------
    rows : (n, sample fields), SI units.
    """
    steps = np.array([f.format.step for f in profile.fixed.sample])
    with np.errstate(all="ignore"):
        scaled = np.where(np.isfinite(rows), np.rint(rows / steps), MISSING)
    return np.clip(scaled, *NARROW).astype(np.int32)


def expected_words(profile: Profile, rows: NDArray[np.int32]) -> Vectors:
    """What the twin answers to rows, as `similitude.embedded.vectors.expected` does for reals."""
    twin = profile.source.library().layout
    config = profile.numbers.values.tolist()
    state = twin.init(config)
    status, outputs = np.empty(len(rows), np.int32), np.empty((len(rows), len(twin.OUTPUT)), np.int32)
    for k, row in enumerate(rows.tolist()):
        status[k], outputs[k] = twin.step(config, state, row)
    last = np.array(state, np.int32)
    return Vectors(rows.view(np.uint32), status, outputs.view(np.uint32), last.view(np.uint32))
