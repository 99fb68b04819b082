/* Steps an estimator on an ATmega328P for the emulator in simulate_avr.c, which fills and reads `box`.
 *
 * GPIOR0: 1 waiting, 2 a sample is there (set by the emulator); GPIOR1: 1 while the step runs, 2 while the report does.
 * Before the first sample the address of the box is told in GPIOR1 and GPIOR2. */

#include <avr/io.h>

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define OF(what) JOIN(NAME, what)
#define TEXT2(a) #a
#define TEXT(a) TEXT2(a)

#include TEXT(OF(_config.h))

static struct {
    OF(_sample) sample;
    int status;
    OF(_output) output;
    OF(_state) state;
} box;

/* A step hands out its output, or leaves it to a report. */
#if OF(_REPORTS)
#define TAKES
#define HANDS(output)
#else
#define TAKES , OF(_output) * y
#define HANDS(output) , output
#endif

typedef int (*step_function)(const OF(_config) *, OF(_state) *, const OF(_sample) * TAKES);

__attribute__((noinline)) static int empty(const OF(_config) * c, OF(_state) * s, const OF(_sample) * x TAKES)
{
    __asm volatile("" : : "r"(c), "r"(s), "r"(x)HANDS("r"(y)) : "memory");
    return 0;
}

int main(void)
{
    volatile step_function step = empty;
    OF(_init)(&OF(_numbers), &box.state);
    GPIOR1 = (unsigned char)((unsigned int)&box & 0xFFu);
    GPIOR2 = (unsigned char)((unsigned int)&box >> 8);
    for (;;) {
        GPIOR0 = 1u;
        while (GPIOR0 != 2u) {
        }
        __asm volatile("" : : : "memory");
        step_function now = step;
        GPIOR1 = 1u;
        box.status = now(&OF(_numbers), &box.state, &box.sample HANDS(&box.output));
        GPIOR1 = 0u;
        __asm volatile("" : : : "memory");
#if OF(_REPORTS)
        GPIOR1 = 2u;
        OF(_report)(&OF(_numbers), &box.state, &box.output);
        GPIOR1 = 0u;
        __asm volatile("" : : : "memory");
#endif
        step = OF(_step);
    }
}
