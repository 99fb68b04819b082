"""The functions that a fixed-point step calls in C; the twin has its own of the same names.

Invariant: each gives the twin's words for any arguments (tests/program/fixed/test_c_functions.py).
"""

from __future__ import annotations

FUNCTIONS = {
    "limit": """\
/* The value of lo..hi that is nearest to x. */
SIMILITUDE_INLINE int32_t {name}_limit(int32_t x, int32_t lo, int32_t hi)
{{
    return (x < lo) ? lo : ((x > hi) ? hi : x);
}}
""",
    "clamp": """\
/* The same of 64 bits, in 32. */
static int32_t {name}_clamp(int64_t x, int32_t lo, int32_t hi)
{{
    return (x < lo) ? lo : ((x > hi) ? hi : (int32_t)x);
}}
""",
    "clamp_wide": """\
/* The same in 64 bits. */
static int64_t {name}_clamp_wide(int64_t x, int64_t lo, int64_t hi)
{{
    return (x < lo) ? lo : ((x > hi) ? hi : x);
}}
""",
    "halves": """\
/* Two words as one value, high 2^32 + low, and the upper one of a value. On an 8-bit part, whose compiler
 * moves 64 bits about one by one, through memory. */
SIMILITUDE_INLINE int64_t {name}_join(int32_t high, int32_t low)
{{
#if defined(__AVR__)
    union {{
        int64_t whole;
        int32_t half[2];
    }} both;
    both.half[0] = low;
    both.half[1] = high - ((low < 0) ? 1 : 0);
    return both.whole;
#else
    return ((int64_t)high * INT64_C(4294967296)) + low;
#endif
}}

SIMILITUDE_INLINE int32_t {name}_upper(int64_t x)
{{
#if defined(__AVR__)
    union {{
        int64_t whole;
        int32_t half[2];
    }} both;
    both.whole = x;
    return both.half[1];
#else
    return (int32_t)(x >> 32);
#endif
}}
""",
    "mulq": """\
/* (a b) >> 32 */
SIMILITUDE_INLINE int32_t {name}_mulq(int32_t a, int32_t b)
{{
    return {name}_upper((int64_t)a * b);
}}
""",
    "mulw": """\
/* About (a b) >> 32 of a wide a. */
static int64_t {name}_mulw(int64_t a, int32_t b)
{{
    const int32_t half = (int32_t)((uint32_t)((uint64_t)a & UINT64_C(0xFFFFFFFF)) >> 1);
    return ((int64_t){name}_upper(a) * b) + ((int64_t){name}_upper((int64_t)half * b) * 2);
}}
""",
    "mulh": """\
/* About (a b) >> 64. */
static int64_t {name}_mulh(int64_t a, int64_t b)
{{
    const int32_t half = (int32_t)((uint32_t)((uint64_t)b & UINT64_C(0xFFFFFFFF)) >> 1);
    const int64_t rest = (int64_t){name}_upper((int64_t)half * {name}_upper(a)) * 2;
    return {name}_mulw(a, {name}_upper(b)) + rest;
}}
""",
    "up": """\
/* x 2^n */
SIMILITUDE_INLINE int64_t {name}_up(int64_t x, int n)
{{
    return (int64_t)((uint64_t)x << n);
}}
""",
    "quotient": """\
/* The first 31 bits of x, from the first that is one; how many bits x has. */
static int32_t {name}_leading(uint64_t x, int *bits)
{{
    const uint32_t low = (uint32_t)(x & UINT64_C(0xFFFFFFFF));
    const uint32_t high = (uint32_t){name}_upper((int64_t)x);
    uint32_t word = (high != 0u) ? high : low;
    int n = 0;
    if (word >= UINT32_C(0x10000)) {{
        word >>= 16;
        n = 16;
    }}
    if (word >= UINT32_C(0x100)) {{
        word >>= 8;
        n += 8;
    }}
    if (word >= UINT32_C(0x10)) {{
        word >>= 4;
        n += 4;
    }}
    if (word >= UINT32_C(0x4)) {{
        word >>= 2;
        n += 2;
    }}
    n += (word >= 2u) ? 2 : (int)word;
    if (high != 0u) {{
        *bits = n + 32;
        return (int32_t)((high << (31 - n)) | ((low >> n) >> 1));
    }}
    *bits = n;
    return (int32_t)((n == 32) ? (low >> 1) : (low << (31 - n)));
}}

/* n 2^up/d to 28 bits, kept in lo..hi; a divisor below one counts as one. The reciprocal of the divisor by a
 * division of 32 bits and a step of Newton's. */
static int32_t {name}_quotient(int64_t n, int64_t d, int up, int32_t lo, int32_t hi)
{{
    const uint64_t size = (n < 0) ? (UINT64_C(0) - (uint64_t)n) : (uint64_t)n;
    int below;
    int above;
    const int32_t under = {name}_leading((d < 1) ? UINT64_C(1) : (uint64_t)d, &below);
    const int32_t over = {name}_leading(size, &above);
    const int32_t first = (int32_t)((UINT32_C(0x7FFFFFFF) / ((uint32_t)under >> 15)) << 15);
    const int32_t miss = INT32_C(0x20000000) - {name}_upper((int64_t)under * first);
    const int32_t inverse = first + {name}_upper((int64_t)first * (miss * 8));
    const uint32_t ratio = (uint32_t){name}_upper((int64_t)over * inverse);
    const int shift = 29 - ((above - below) + up);
    uint32_t found;
    if ((n == 0) || (shift > 31)) {{
        found = 0u;
    }} else if (shift < -2) {{
        found = UINT32_C(0xFFFFFFFF);
    }} else if (shift <= 0) {{
        found = ratio << -shift;
    }} else {{
        found = (ratio + (UINT32_C(1) << (shift - 1))) >> shift;
    }}
    found = (found > UINT32_C(0x7FFFFFFF)) ? UINT32_C(0x7FFFFFFF) : found;
    return {name}_limit((n < 0) ? -(int32_t)found : (int32_t)found, lo, hi);
}}
""",
}
NEEDS = {
    "quotient": ("limit", "halves"),
    "mulh": ("mulw", "halves"),
    "mulw": ("halves",),
    "mulq": ("halves",),
}
