/* Runs an estimator on an emulated board, by semihosting; built with -DNAME=bicycle_paper.
 *
 * Without a file rows.bin: the self-test, and what a step costs over its samples, is printed.
 * With it: its rows are streamed through the estimator into words.bin, a record a row: status, ticks of
 * the step, bytes of stack it used, ticks of the report (0 where the step hands out everything), outputs;
 * then the last state. Before the first row a record of an empty call: what measuring costs by itself. */

#include "board.h"

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define OF(what) JOIN(NAME, what)
#define TEXT2(a) #a
#define TEXT(a) TEXT2(a)

#include TEXT(OF(_config.h))
#include TEXT(OF(_self_test.h))
#include TEXT(OF(_vectors.h))

enum { SYS_OPEN = 1, SYS_WRITE0 = 4, SYS_WRITE = 5, SYS_READ = 6, SYS_EXIT = 0x18, SYS_EXIT_EXTENDED = 0x20 };
enum { PAINT = 3072, READ_BINARY = 1, WRITE_BINARY = 5 };

void *memcpy(void *to, const void *from, unsigned int n);
void *memset(void *to, int value, unsigned int n);

__attribute__((optimize("no-tree-loop-distribute-patterns"))) void *memcpy(void *to, const void *from, unsigned int n)
{
    unsigned char *t = to;
    const unsigned char *f = from;
    while (n-- > 0u) {
        *t++ = *f++;
    }
    return to;
}

__attribute__((optimize("no-tree-loop-distribute-patterns"))) void *memset(void *to, int value, unsigned int n)
{
    unsigned char *t = to;
    while (n-- > 0u) {
        *t++ = (unsigned char)value;
    }
    return to;
}

void leave(int code)
{
    unsigned long why[2] = {0x20026ul, (unsigned long)code};
    (void)call_host(SYS_EXIT_EXTENDED, why);
    (void)call_host(SYS_EXIT, (void *)0x20026ul);
    for (;;) {
    }
}

static long open_file(const char *name, unsigned long length, unsigned long mode)
{
    unsigned long block[3];
    block[0] = (unsigned long)name;
    block[1] = mode;
    block[2] = length;
    return call_host(SYS_OPEN, block);
}

/* Bytes that were not read or written. */
static unsigned long transfer(long operation, long file, void *bytes, unsigned long n)
{
    unsigned long block[3];
    block[0] = (unsigned long)file;
    block[1] = (unsigned long)bytes;
    block[2] = n;
    return (unsigned long)call_host(operation, block);
}

typedef struct record {
    unsigned long status;
    unsigned long ticks;
    unsigned long stack;
    unsigned long report;
    OF(_output) output;
} record;

/* A step hands out its output, or leaves it to a report. */
#if OF(_REPORTS)
#define TAKES
#define HANDS(output)
#else
#define TAKES , OF(_output) * y
#define HANDS(output) , output
#endif

typedef int (*step_function)(const OF(_config) *, OF(_state) *, const OF(_sample) * TAKES);

static OF(_state) state;
static OF(_sample) sample;
static record now;

__attribute__((noinline)) static int empty(const OF(_config) * c, OF(_state) * s, const OF(_sample) * x TAKES)
{
    __asm volatile("" : : "r"(c), "r"(s), "r"(x)HANDS("r"(y)) : "memory");
    return 0;
}

__attribute__((noinline)) static void paint(void)
{
    volatile unsigned char area[PAINT];
    unsigned long i;
    for (i = 0ul; i < PAINT; ++i) {
        area[i] = 0xA5u;
    }
}

__attribute__((noinline)) static unsigned long painted(void)
{
    volatile unsigned char area[PAINT];
    unsigned long i = 0ul;
    while ((i < PAINT) && (area[i] == 0xA5u)) {
        ++i;
    }
    return PAINT - i;
}

__attribute__((noinline)) static void measure(step_function step)
{
    unsigned long before;
    unsigned long after;
    before = ticks();
    now.status = (unsigned long)step(&OF(_numbers), &state, &sample HANDS(&now.output));
    after = ticks();
    now.ticks = (after - before) & 0xFFFFFFul;
}

/* The output, where the step leaves it to a report. */
static void complete(void)
{
#if OF(_REPORTS)
    unsigned long before = ticks();
    OF(_report)(&OF(_numbers), &state, &now.output);
    now.report = (ticks() - before) & 0xFFFFFFul;
#endif
}

static void say(const char *text)
{
    (void)call_host(SYS_WRITE0, (void *)text);
}

static void say_number(unsigned long number)
{
    char digits[12];
    unsigned long at = 11ul;
    digits[at] = '\0';
    do {
        digits[--at] = (char)('0' + (number % 10ul));
        number /= 10ul;
    } while (number != 0ul);
    say(&digits[at]);
}

/* The self-test, then its samples once more with each step measured. */
static void report(void)
{
    enum { FIELDS = sizeof(OF(_sample)) / sizeof(OF(_real)) };
    unsigned long n = sizeof(OF(_samples)) / sizeof(OF(_sample));
    unsigned long long sum = 0ull;
    unsigned long most = 0ul;
    unsigned long asked = 0ul;
    unsigned long stack = 0ul;
    unsigned long wrong = OF(_self_test)((unsigned long *)0);
    unsigned long k;
    unsigned long by_itself;
    unsigned long own_stack;
    paint();
    measure(empty);
    own_stack = painted();
    by_itself = now.ticks;
    OF(_init)(&OF(_numbers), &state);
    for (k = 0ul; k < n; ++k) {
        unsigned long cost;
        (void)memcpy(&sample, &OF(_samples)[FIELDS * k], sizeof sample);
        paint();
        measure(OF(_step));
        stack = (painted() > stack) ? painted() : stack;
        cost = instructions(now.ticks - by_itself);
        most = (cost > most) ? cost : most;
        complete();
        asked = (now.report > asked) ? now.report : asked;
        sum += cost;
    }
    say("words that differ: ");
    say_number(wrong);
    say("\ninstructions a sample, mean: ");
    say_number((unsigned long)((sum + (n / 2ul)) / n));
    say("\ninstructions a sample, most: ");
    say_number(most);
    if (asked > by_itself) {
        say("\ninstructions of a report, most: ");
        say_number(instructions(asked - by_itself));
    }
    say("\nstack of a step, bytes: ");
    say_number(stack - own_stack);
    say("\n");
    leave((wrong == 0ul) ? 0 : 1);
}

void stream(void)
{
    long rows = open_file("rows.bin", 8ul, READ_BINARY);
    long words;
    volatile step_function step = empty;
    if (rows < 0) {
        report();
    }
    words = open_file("words.bin", 9ul, WRITE_BINARY);
    if (words < 0) {
        leave(2);
    }
    OF(_init)(&OF(_numbers), &state);
    do {
        paint();
        measure(step);
        now.stack = painted();
        complete();
        if (transfer(SYS_WRITE, words, &now, sizeof now) != 0ul) {
            leave(3);
        }
        step = OF(_step);
    } while (transfer(SYS_READ, rows, &sample, sizeof sample) == 0ul);
    if (transfer(SYS_WRITE, words, &state, sizeof state) != 0ul) {
        leave(3);
    }
}
