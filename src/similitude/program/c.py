"""Prints a step program as one freestanding C99 file: structs, init, step and the batch loop.

Invariant: the file needs no header, no heap, no mathematics library and no global; bounded time.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import sympy as sp

from similitude.program.ir import Assign, Field, Program, Statement, When, walk, without_unread
from similitude.program.parts import Part, parts_of, runs
from similitude.program.text import C, Language, count_operations, expression_text

_HEAD = """\
/* {title}. Generated from its model by similitude; do not edit.
 *
{provenance}
 *
 * Operations: step {most} at most, {least} at least (arithmetic, comparisons, selects), {report}init {init}.
 * Memory: state {state} reals, configuration {config} reals; no heap, no globals, no libm, C99.
 * Build with -ffp-contract=off: with it every IEEE-754 target gives the same bits.
 */

#ifndef SIMILITUDE_REAL
#define SIMILITUDE_REAL double
#endif
#ifndef SIMILITUDE_API
#if defined(_WIN32)
#define SIMILITUDE_API __declspec(dllexport)
#elif defined(__GNUC__)
#define SIMILITUDE_API __attribute__((visibility("default")))
#else
#define SIMILITUDE_API
#endif
#endif
#ifndef SIMILITUDE_INLINE
#if defined(__GNUC__)
#define SIMILITUDE_INLINE static inline __attribute__((always_inline))
#else
#define SIMILITUDE_INLINE static inline
#endif
#endif
#ifndef SIMILITUDE_PART
#define SIMILITUDE_PART SIMILITUDE_INLINE
#endif

typedef SIMILITUDE_REAL {name}_real;
#define R(x) (({name}_real)(x))
"""

SHORTER_AS_LOOP = 8  # zeros in a row of an array; fewer are as short one by one
# |x| against a limit: a sign bit cleared where the compiler has a word for it, two comparisons elsewhere.
_MAGNITUDE = """\
#if defined(__GNUC__)
#define MAGNITUDE(x) \\
    ((sizeof(SIMILITUDE_REAL) == sizeof(float)) ? R(__builtin_fabsf((float)(x))) \\
                                                : R(__builtin_fabs((double)(x))))
#define WITHIN(x, limit) (MAGNITUDE(x) < (limit))
#define BEYOND(x, limit) (MAGNITUDE(x) > (limit))
#else
#define WITHIN(x, limit) (((x) < (limit)) && ((x) > -(limit)))
#define BEYOND(x, limit) (((x) > (limit)) || ((x) < -(limit)))
#endif
"""

# The batch loop advances a state of its own: no write through a pointer can reach it, so the compiler
# need not write it back after every sample (a fifth of the population filter's time, a third of the paper's).
LOOPS = """\
/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int {name}_step(const {name}_config *config, {name}_state *state,
                               const {name}_sample *sample{takes})
{{
    return {name}_advance(config, state, sample{hands});
}}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long {name}_batch(const {name}_config *config, {name}_state *state, long n,
                                 const {name}_sample *samples, {name}_output *outputs, int *status)
{{
    {name}_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        {advance}
    *state = now;
    return n;
}}
"""
ADVANCE = "status[i] = {name}_advance(config, &now, &samples[i], &outputs[i]);"
REPORTED = """\
{{
            status[i] = {name}_advance(config, &now, &samples[i]);
            {name}_report(config, &now, &outputs[i]);
        }}"""


@dataclass(frozen=True)
class _Scope:
    """What printing a body needs to know of its program."""

    name: str
    mutable: frozenset[str]
    language: Language
    parts: Mapping[str, Part]


def _scope(program: Program, mutable: set[str]) -> _Scope:
    """Structs are read and written where they stand: what is copied early only waits, on the stack."""
    places = _places(program.config, "config") | _places(program.sample, "sample")
    names = places | _places(program.state, "state") | _element(program.state)
    language = replace(C, names=names, whole=whole_variables(program))
    return _Scope(program.name, frozenset(mutable), language, parts_of(program))


def whole_variables(program: Program) -> frozenset[str]:
    """Variables of a step that are nothing but flags and codes: set to whole constants and compared to such.

    They are printed as ``int``; the twin's floats take the same ways.
    """
    found = {f.name for f in program.variables if f.size == 1}
    for s in walk(program.step):
        node = s.condition if isinstance(s, When) else s.expression
        if isinstance(s, Assign) and not s.expression.is_Integer:
            found.discard(s.target)
        plain = {r: sp.true for r in node.atoms(sp.core.relational.Relational) if _with_constant(r)}
        found -= {symbol.name for symbol in node.xreplace(plain).free_symbols}
    return frozenset(found)


def _with_constant(r: sp.core.relational.Relational) -> bool:
    return r.lhs.is_Symbol and r.rhs.is_Rational and r.rel_op in ("<", ">", "<=", ">=")


def print_c(program: Program) -> str:
    """The whole C file of a step program.

    Returns
    -------
    str    source text, ASCII, ending in a newline.
    """
    program = without_unread(program)
    name = program.name
    status = "".join(
        f"    {name.upper()}_{key.upper()} = {code},\n" for key, code in program.status.items()
    ).rstrip(",\n")
    parts = [
        _HEAD.format(
            title=program.title,
            name=name,
            provenance="\n".join(f" *   {line}" for line in program.provenance),
            most=operations(program.step, most=True),
            least=operations(program.step, most=False),
            report=f"report {operations(program.report, most=True)}, " if program.report else "",
            init=operations(program.init, most=True),
            state=sum(f.size for f in program.state),
            config=sum(f.size for f in program.config),
        ),
        f"enum {name}_status {{\n{status}\n}};\n",
    ]
    for kind in ("config", "state", "sample", "output"):
        parts.append(_struct(name, kind, getattr(program, kind)))
    bodies = [_init(program), _advance(program)]
    if any("WITHIN(" in body for body in bodies):
        parts.insert(1, _MAGNITUDE)
    bodies += [_report(program)] if program.report else []
    return "\n".join([*parts, *bodies, loops(name, reports=bool(program.report))])


def loops(name: str, *, reports: bool) -> str:
    """The exported step and the batch loop around ``NAME_advance``, which hands out or ``reports``."""
    return LOOPS.format(
        name=name,
        takes="" if reports else f", {name}_output *output",
        hands="" if reports else ", output",
        advance=(REPORTED if reports else ADVANCE).format(name=name),
    )


def operations(body: Iterable[Statement], *, most: bool) -> int:
    """Operations of a body along its longest (or shortest) way through the guards."""
    total = 0
    for statement in body:
        if isinstance(statement, When):
            total += count_operations(expression_text(statement.condition, C))
            ways = [
                operations(statement.body, most=most),
                operations(statement.otherwise, most=most),
            ]
            total += max(ways) if most else min(ways)
        else:
            total += count_operations(expression_text(statement.expression, C))
    return total


def _struct(name: str, kind: str, fields: tuple[Field, ...]) -> str:
    lines = [f"typedef struct {name}_{kind} {{"]
    for f in fields:
        declared = f"{name}_real {f.name}{f'[{f.size}]' if f.size > 1 else ''};"
        lines.append(f"    {declared:<48} /* [{f.unit}] {f.meaning} */")
    return "\n".join([*lines, f"}} {name}_{kind};\n"])


def _places(fields: Iterable[Field], struct: str) -> dict[str, str]:
    """C text of every real of a struct, such as ``config->biquad_1[0]``."""
    return {
        symbol.name: f"{struct}->{f.name}{f'[{i}]' if f.size > 1 else ''}"
        for f in fields
        for i, symbol in enumerate(f.symbols)
    }


def _arrays(fields: Iterable[Field], name: str) -> list[str]:
    """Pointers to the state's arrays, which are updated in place rather than copied in and out."""
    return [f"    {name}_real *const {f.name} = state->{f.name};" for f in fields if f.size > 1]


def _element(fields: Iterable[Field]) -> dict[str, str]:
    """C text of every array element that is updated in place."""
    return {s.name: f"{f.name}[{i}]" for f in fields if f.size > 1 for i, s in enumerate(f.symbols)}


def _stores(fields: Iterable[Field], written: set[str], target: str) -> list[str]:
    lines = []
    for f in fields:
        for i, symbol in enumerate(f.symbols):
            if symbol.name in written:
                place = f"{target}->{f.name}{f'[{i}]' if f.size > 1 else ''}"
                lines.append(f"    {place} = {symbol.name};")
    return lines


def names_read(body: Iterable[Statement]) -> set[str]:
    """Every name a body reads."""
    names: set[str] = set()
    for statement in walk(body):
        node = statement.condition if isinstance(statement, When) else statement.expression
        names |= {s.name for s in node.free_symbols}
    return names


def names_written(body: Iterable[Statement]) -> set[str]:
    """Every name a body assigns."""
    return {s.target for s in walk(body) if isinstance(s, Assign)}


def _body(body: tuple[Statement, ...], scope: _Scope, depth: int) -> list[str]:
    lines = []
    for name, some in runs(body):
        lines += [_call(scope.parts[name], scope, depth)] if name else _plain(some, scope, depth)
    return lines


def _plain(body: Iterable[Statement], scope: _Scope, depth: int) -> list[str]:
    pad = "    " * depth
    lines = []
    for s in body:
        if isinstance(s, When):
            lines += _guard(s, scope, depth)
            continue
        is_whole = s.target in scope.language.whole
        text = str(int(s.expression)) if is_whole else expression_text(s.expression, scope.language)
        kind = "" if s.target in scope.mutable else f"const {scope.name}_real "
        comment = f" /* {s.comment} */" if s.comment else ""
        target = scope.language.names.get(s.target, s.target)
        lines.append(f"{pad}{kind}{target} = {text};{comment}")
    return lines


def _call(part: Part, scope: _Scope, depth: int) -> str:
    return f"{'    ' * depth}{scope.name}_{part.name}({', '.join([*part.structs, *part.arguments])});"


def _function(part: Part, program: Program, scope: _Scope) -> str:
    """A part of the step as a function; what it takes stands in the order of its first use."""
    name = program.name
    constant = {"config": "const ", "state": "", "sample": "const "}
    takes = [f"{constant[kind]}{name}_{kind} *{kind}" for kind in part.structs]
    takes += [f"const {'int' if a in scope.language.whole else f'{name}_real'} {a}" for a in part.arguments]
    arrays = {s.name: f for f in program.state for s in f.symbols if f.size > 1}
    used = names_read(part.body) | names_written(part.body)
    fields = {arrays[n].name: arrays[n] for n in arrays if n in used}
    gap = ",\n" + " " * 8
    return "\n".join(
        [
            f"/* A part of the step: {part.name}. */",
            f"SIMILITUDE_PART void {name}_{part.name}(",
            f"        {gap.join(takes)})",
            "{",
            *_arrays(fields.values(), name),
            *_plain(part.body, scope, 1),
            "}\n",
        ]
    )


def _guard(s: When, scope: _Scope, depth: int) -> list[str]:
    pad = "    " * depth
    comment = f" /* {s.comment} */" if s.comment else ""
    condition = expression_text(s.condition, scope.language)
    if not s.body:
        condition, body, otherwise = f"!({condition})", s.otherwise, ()
    else:
        body, otherwise = s.body, s.otherwise
    lines = [f"{pad}if ({condition}) {{{comment}", *_body(body, scope, depth + 1)]
    if otherwise:
        lines += [f"{pad}}} else {{", *_body(otherwise, scope, depth + 1)]
    return [*lines, f"{pad}}}"]


def _init(program: Program) -> str:
    name = program.name
    read = names_read(program.init)
    lines = [
        "/* The state before the first sample: the prior. */",
        f"SIMILITUDE_API void {name}_init(const {name}_config *config, {name}_state *state)",
        "{",
        *([] if read & {s.name for f in program.config for s in f.symbols} else ["    (void)config;"]),
        *_arrays(program.state, name),
        *_prior(program),
        "}\n",
    ]
    return "\n".join(lines)


def _prior(program: Program) -> list[str]:
    """The statements of ``init``; an array that begins with zeros in one loop, which is shorter."""
    scope = _scope(program, {s.name for f in program.state for s in f.symbols})
    body, loops = list(program.init), []
    for f in program.state:
        if f.size < SHORTER_AS_LOOP:
            continue
        zeros = [Assign(symbol.name, sp.Integer(0)) for symbol in f.symbols]
        at = body.index(zeros[0]) if zeros[0] in body else 0
        touched = names_read(body[:at]) | names_written(body[:at])
        if body[at : at + f.size] == zeros and touched.isdisjoint(z.target for z in zeros):
            del body[at : at + f.size]
            loops += [f"    for (i = 0; i < {f.size}; ++i) {{", f"        {f.name}[i] = R(0.0);", "    }"]
    return [*(["    int i;"] if loops else []), *loops, *_body(tuple(body), scope, 1)]


def _declared(name: str, scope: _Scope) -> str:
    return (
        f"    int {name} = 0;" if name in scope.language.whole else f"    {scope.name}_real {name} = R(0.0);"
    )


def _advance(program: Program) -> str:
    name = program.name
    written = names_written(program.step)
    outputs = {s.name for f in program.output for s in f.symbols}
    states = {s.name for f in program.state for s in f.symbols}
    working = {f.name for f in program.variables}
    scope = _scope(program, states | outputs | working)
    takes = "" if program.report else f", {name}_output *output"
    lines = [
        *(_function(part, program, scope) for part in scope.parts.values()),
        "/* What the step and the batch loop do with one sample. */",
        f"SIMILITUDE_INLINE int {name}_advance(const {name}_config *config, {name}_state *state,",
        f"                                     const {name}_sample *sample{takes})",
        "{",
        *_arrays(program.state, name),
        *[_declared(n, scope) for n in sorted((outputs | working) & written)],
        "",
        *_body(program.step, scope, 1),
        "",
        *_stores(program.output, written, "output"),
        "    return status;" if "status" in scope.language.whole else "    return (int)status;",
        "}\n",
    ]
    return "\n".join(lines)


def _report(program: Program) -> str:
    """What of the output follows from the state, for whoever asks."""
    name = program.name
    written = names_written(program.report)
    outputs = {s.name for f in program.output for s in f.symbols}
    scope = _scope(program, outputs)
    state = {key: f"state->{text}" for key, text in _element(program.state).items()}
    scope = replace(scope, language=replace(scope.language, names={**scope.language.names, **state}))
    return "\n".join(
        [
            "/* Every output, from the state as it is: at any time between two steps. */",
            f"SIMILITUDE_API void {name}_report(const {name}_config *config, const {name}_state *state,",
            f"                                  {name}_output *output)",
            "{",
            *[_declared(n, scope) for n in sorted(outputs & written)],
            "",
            *_body(program.report, scope, 1),
            "",
            *_stores(program.output, written, "output"),
            "}\n",
        ]
    )
