"""Prints a step program as one freestanding C99 file: structs, init, step and the batch loop.

Invariant: the file needs no header, no heap, no mathematics library and no global; bounded time.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from similitude.program.ir import Assign, Field, Program, Statement, When, walk, without_unread
from similitude.program.text import C, Language, count_operations, expression_text

_HEAD = """\
/* {title}. Generated from its model by similitude; do not edit.
 *
{provenance}
 *
 * Operations: step {most} at most, {least} at least (arithmetic, comparisons, selects), init {init}.
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

typedef SIMILITUDE_REAL {name}_real;
#define R(x) (({name}_real)(x))
"""

# The batch loop advances a state of its own: no write through a pointer can reach it, so the compiler
# need not write it back after every sample (a fifth of the population filter's time, a third of the paper's).
LOOPS = """\
/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int {name}_step(const {name}_config *config, {name}_state *state,
                               const {name}_sample *sample, {name}_output *output)
{{
    return {name}_advance(config, state, sample, output);
}}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long {name}_batch(const {name}_config *config, {name}_state *state, long n,
                                 const {name}_sample *samples, {name}_output *outputs, int *status)
{{
    {name}_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = {name}_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}}
"""


@dataclass(frozen=True)
class _Scope:
    """What printing a body needs to know of its program."""

    name: str
    mutable: frozenset[str]
    language: Language


def _scope(program: Program, mutable: set[str]) -> _Scope:
    return _Scope(program.name, frozenset(mutable), replace(C, names=_element(program.state)))


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
            init=operations(program.init, most=True),
            state=sum(f.size for f in program.state),
            config=sum(f.size for f in program.config),
        ),
        f"enum {name}_status {{\n{status}\n}};\n",
    ]
    for kind in ("config", "state", "sample", "output"):
        parts.append(_struct(name, kind, getattr(program, kind)))
    parts += [_init(program), _advance(program), LOOPS.format(name=name)]
    return "\n".join(parts)


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


def _locals(fields: Iterable[Field], used: set[str], name: str, source: str, qualifier: str) -> list[str]:
    lines = []
    for f in fields:
        for i, symbol in enumerate(f.symbols):
            if symbol.name in used:
                place = f"{source}->{f.name}{f'[{i}]' if f.size > 1 else ''}"
                lines.append(f"    {qualifier}{name}_real {symbol.name} = {place};")
    return lines


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


def _body(body: Iterable[Statement], scope: _Scope, depth: int) -> list[str]:
    pad = "    " * depth
    lines = []
    for s in body:
        if isinstance(s, When):
            lines += _guard(s, scope, depth)
            continue
        text = expression_text(s.expression, scope.language)
        kind = "" if s.target in scope.mutable else f"const {scope.name}_real "
        comment = f" /* {s.comment} */" if s.comment else ""
        target = scope.language.names.get(s.target, s.target)
        lines.append(f"{pad}{kind}{target} = {text};{comment}")
    return lines


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
    scope = _scope(program, {s.name for f in program.state for s in f.symbols})
    written = names_written(program.init)
    single = {s.name for f in program.state if f.size == 1 for s in f.symbols}
    declared = [f"    {name}_real {n};" for n in sorted(single & written)]
    lines = [
        "/* The state before the first sample: the prior. */",
        f"SIMILITUDE_API void {name}_init(const {name}_config *config, {name}_state *state)",
        "{",
        *([] if read & {s.name for f in program.config for s in f.symbols} else ["    (void)config;"]),
        *_locals(program.config, read, name, "config", "const "),
        *_arrays(program.state, name),
        *declared,
        *_body(program.init, scope, 1),
        *_stores(program.state, written & single, "state"),
        "}\n",
    ]
    return "\n".join(lines)


def _advance(program: Program) -> str:
    name = program.name
    read, written = names_read(program.step), names_written(program.step)
    outputs = {s.name for f in program.output for s in f.symbols}
    states = {s.name for f in program.state for s in f.symbols}
    working = {f.name for f in program.variables}
    scope = _scope(program, states | outputs | working)
    single = {s.name for f in program.state if f.size == 1 for s in f.symbols}
    lines = [
        "/* What the step and the batch loop do with one sample. */",
        f"SIMILITUDE_INLINE int {name}_advance(const {name}_config *config, {name}_state *state,",
        f"                                     const {name}_sample *sample, {name}_output *output)",
        "{",
        *_locals(program.config, read, name, "config", "const "),
        *_locals(program.sample, read, name, "sample", "const "),
        *_arrays(program.state, name),
        *_locals(program.state, (read | written) & single, name, "state", ""),
        *[f"    {name}_real {n} = R(0.0);" for n in sorted((outputs | working) & written)],
        "",
        *_body(program.step, scope, 1),
        "",
        *_stores(program.state, written & single, "state"),
        *_stores(program.output, written, "output"),
        "    return (int)status;",
        "}\n",
    ]
    return "\n".join(lines)
