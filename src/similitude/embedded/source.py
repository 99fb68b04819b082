"""An exported estimator's header and C file, cut out of the text that the generator prints.

Invariant: nothing of the step is printed here. The declarations, ``init`` and the body of the step are
the bytes of the committed C (or of a fresh `program.c.print_c`); what is added around them is the
contract, the guards against a compiler that changes bits, and the saved state.
"""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass

from similitude.embedded.targets import BYTES, CONTRACT_OFF
from similitude.errors import ProgramError

FED = " in the first four fields (the others are what the filter's step handed out)"

_HEADER = """\
/* {name}.h: {title}. Exported by similitude {version}; do not edit.
 *
{provenance}
 *
 * Contract
 *   Language   C99, freestanding: includes nothing, calls nothing but compiler arithmetic. No heap, no libm.
 *   Memory     no globals. The caller owns the state: {states} reals, {state_bytes} bytes.
 *   Time       bounded: a step has no loop and at most {most} operations; init, saving and restoring
 *              loop a constant number of times.
 *   Names      every symbol begins with {name}_.
 *   Samples    any bits may come in{except_fed}, NaN and infinity included. A sample that cannot be
 *              used changes the status, never the ability to use the next one; what goes out is finite.
 *   Status     the names of the Python package: {names}.
 *   Bits       every operation rounds once, in the order written: with fused multiply-add forbidden
 *              (-ffp-contract=off) every IEEE-754 target gives the same bits as the host.
 *   Order      init (or restore), then one step a sample. A step of one state is not to be interrupted
 *              by another of the same state; different states are independent.
 */

#ifndef {guard}
#define {guard}

#ifdef __cplusplus
extern "C" {{
#endif

typedef {real} {name}_real;
typedef char {name}_real_has_{bytes}_bytes[(sizeof({name}_real) == {bytes}u) ? 1 : -1];

{declarations}
/* Bytes of a saved state: what it is, for which configuration, the state, a checksum. */
enum {{ {upper}_SAVED_BYTES = {saved} }};

/* The state before the first sample: the prior. */
void {name}_init(const {name}_config *config, {name}_state *state);

/* One sample: returns a status. */
int {name}_step(const {name}_config *config, {name}_state *state,
                const {name}_sample *sample{takes});
{report}
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

#if defined(__FAST_MATH__)
#error "-ffast-math reorders arithmetic and takes NaN for a number: build without it"
#endif
#if defined(__FLT_EVAL_METHOD__)
#if (__FLT_EVAL_METHOD__ != 0) && (__FLT_EVAL_METHOD__ != 16)
#error "this compiler keeps more digits than the type has: on x86 build with -msse2 -mfpmath=sse"
#endif
#endif
#if defined(__FP_FAST_FMA) || defined(__FP_FAST_FMAF) || defined(__ARM_FEATURE_FMA) || defined(__FMA__)
#if !defined({contract_off})
#error "this processor fuses multiply and add: build with -ffp-contract=off -D{contract_off}"
#endif
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

#define SIMILITUDE_API
#define SIMILITUDE_INLINE static inline
#define R(x) (({name}_real)(x))
{magnitude}{part}
{bodies}
SIMILITUDE_API int {name}_step(const {name}_config *config, {name}_state *state,
                               const {name}_sample *sample{takes})
{{
    return {name}_advance(config, state, sample{hands});
}}

"""

_REPORT = """
/* The output, from the state as it is: called when it is wanted, at any time between two steps. */
#define {name}_REPORTS 1 /* tells a harness that there is a report */
void {name}_report(const {name}_config *config, const {name}_state *state, {name}_output *output);
"""

SAVING = """\
/* CRC-32 (IEEE 802.3) of n bytes, without its last inversion. */
static unsigned long {name}_checksum(const unsigned char *bytes, unsigned long n)
{{
    unsigned long crc = 0xFFFFFFFFUL;
    unsigned long i;
    unsigned int bit;
    for (i = 0UL; i < n; ++i) {{
        crc = crc ^ (unsigned long)bytes[i];
        for (bit = 0u; bit < 8u; ++bit) {{
            crc = ((crc & 1UL) != 0UL) ? ((crc >> 1u) ^ 0xEDB88320UL) : (crc >> 1u);
        }}
    }}
    return crc;
}}

static void {name}_put(unsigned char *bytes, unsigned long word)
{{
    unsigned int i;
    for (i = 0u; i < 4u; ++i) {{
        bytes[i] = (unsigned char)((word >> (8UL * (unsigned long)i)) & 0xFFUL);
    }}
}}

/* What 8 bytes before a state must be: of which version, for which configuration. */
static void {name}_label(const {name}_config *config, unsigned char *bytes)
{{
    {name}_put(bytes, 0x{version_word:08X}UL); /* of the structs and the real */
    {name}_put(&bytes[4], {name}_checksum((const unsigned char *)config, sizeof(*config)));
}}

void {name}_save(const {name}_config *config, const {name}_state *state, unsigned char *bytes)
{{
    const unsigned char *const from = (const unsigned char *)state;
    unsigned long i;
    {name}_label(config, bytes);
    for (i = 0UL; i < sizeof(*state); ++i) {{
        bytes[8UL + i] = from[i];
    }}
    {name}_put(&bytes[8UL + sizeof(*state)],
               {name}_checksum(bytes, 8UL + sizeof(*state)));
}}

int {name}_restore(const {name}_config *config, {name}_state *state, const unsigned char *bytes)
{{
    unsigned char *const to = (unsigned char *)state;
    unsigned char wanted[12];
    unsigned int differ = 0u;
    unsigned long i;
    {name}_label(config, wanted);
    {name}_put(&wanted[8], {name}_checksum(bytes, 8UL + sizeof(*state)));
    for (i = 0UL; i < 8UL; ++i) {{
        differ |= (unsigned int)(wanted[i] ^ bytes[i]);
    }}
    for (i = 0UL; i < 4UL; ++i) {{
        differ |= (unsigned int)(wanted[8UL + i] ^ bytes[8UL + sizeof(*state) + i]);
    }}
    if (differ == 0u) {{
        for (i = 0UL; i < sizeof(*state); ++i) {{
            to[i] = bytes[8UL + i];
        }}
    }} else {{
        {name}_init(config, state);
    }}
    return (differ == 0u) ? (int){upper}_OK : (int){upper}_RESTARTED;
}}
"""


_MAGNITUDE = """\
/* |x| against a limit: a sign bit cleared, no call. Frama-C is shown the comparisons, which it can follow. */
#if defined(__GNUC__) && !defined(__FRAMAC__)
{quick}
#else
{plain}
#endif
"""
_QUICK = {"WITHIN": "({builtin}(x) < (limit))", "BEYOND": "({builtin}(x) > (limit))"}
_PLAIN = {
    "WITHIN": "(((x) < (limit)) && ((x) > -(limit)))",
    "BEYOND": "(((x) > (limit)) || ((x) < -(limit)))",
}

_PART = """\
/* A part of the step: a function of its own, so that the compiler keeps fewer values waiting on the stack. */
#if defined(__GNUC__)
#define SIMILITUDE_PART static __attribute__((noinline))
#else
#define SIMILITUDE_PART static
#endif
"""


@dataclass(frozen=True)
class Cut:
    """The generator's text of one program in parts; joined again it is the text."""

    head: str
    declarations: str
    bodies: str
    loops: str

    @property
    def text(self) -> str:
        """The whole, as it was."""
        return self.head + self.declarations + self.bodies + self.loops


def cut(text: str, name: str) -> Cut:
    """Cut generated C into its comment and macros, declarations, ``init`` and the step's body, loops.

    Raises
    ------
    ProgramError    the text is not what the generator prints.
    """
    marks = (
        f"enum {name}_status {{",
        "/* The state before the first sample: the prior. */",
        "/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */",
    )
    places = [text.find(mark) for mark in marks]
    if min(places) < 0 or places != sorted(places):
        raise ProgramError(
            f"the C of {name} has no longer the four parts an export is made of",
            usually="The generator's text was changed, and the marks of embedded/source.py were not.",
            paste="python -m similitude.generate",
            read='docs/embedded.md, "One source"',
        )
    enum, init, loops = places
    return Cut(text[:enum], text[enum:init], text[init:loops], text[loops:])


@dataclass(frozen=True)
class Sources:
    """Text of ``NAME.h`` and ``NAME.c``."""

    header: str
    source: str


def print_sources(
    text: str, name: str, *, real: str, states: int, status: dict[str, int], version: str
) -> Sources:
    """Header and C file of an exported estimator.

    Parameters
    ----------
    text : what the generator printed for the estimator.
    real : ``float`` or ``double``.
    states : reals of the state.
    version : of the package, for the comment.

    Raises
    ------
    ProgramError    the text is not the generator's.
    """
    parts = cut(text, name)
    reports = f"{name}_report(" in parts.bodies
    title = re.match(r"/\* (.*?)\. Generated", parts.head)
    counts = re.search(r"step (\d+) at most, (\d+) at least", parts.head)
    told = re.search(r"do not edit\.\n \*\n(.*?)\n \*\n \* Operations", parts.head, re.S)
    words = {
        "name": name,
        "upper": name.upper(),
        "guard": f"{name.upper()}_H",
        "title": title.group(1),
        "provenance": told.group(1),
        "most": counts.group(1),
        "least": counts.group(2),
        "version": version,
        "real": real,
        "bytes": BYTES[real],
        "states": states,
        "state_bytes": states * BYTES[real],
        "saved": 12 + states * BYTES[real],
        "names": ", ".join(status),
        "takes": "" if reports else f", {name}_output *output",
        "hands": "" if reports else ", output",
        "report": _REPORT.format(name=name) if reports else "",
        "declarations": parts.declarations,
        "bodies": parts.bodies,
        "magnitude": _magnitude(parts.bodies, real),
        "part": _PART if "SIMILITUDE_PART" in parts.bodies else "",
        "except_fed": FED if name.endswith("_monitor") else "",
        "contract_off": CONTRACT_OFF,
        "version_word": int(hashlib.sha256((real + parts.declarations).encode()).hexdigest()[:8], 16),
    }
    return Sources(_HEADER.format(**words), (_SOURCE + SAVING).format(**words))


def _magnitude(bodies: str, real: str) -> str:
    """The macros that the step uses, and no other."""
    used = [name for name in _QUICK if f"{name}(" in bodies]
    if not used:
        return ""
    builtin = "__builtin_fabsf" if real == "float" else "__builtin_fabs"
    quick = "\n".join(f"#define {n}(x, limit) {_QUICK[n].format(builtin=builtin)}" for n in used)
    plain = "\n".join(f"#define {n}(x, limit) {_PLAIN[n]}" for n in used)
    return _MAGNITUDE.format(quick=quick, plain=plain)
