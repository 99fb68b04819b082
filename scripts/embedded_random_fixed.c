/* Random words through an exported fixed-point estimator, under sanitizers: any bits, the ends, believable values.
 *
 * Built with -DNAME=bicycle_paper_fixed -DSAMPLES=1000000. Ends with 0 where every status was one of the list, 300
 * good samples after the storm are used and the self-test finds no word that differs. */

#include <stdint.h>
#include <stdio.h>

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define OF(what) JOIN(NAME, what)
#define TEXT2(a) #a
#define TEXT(a) TEXT2(a)

#include TEXT(OF(_config.h))
#include TEXT(OF(_self_test.h))
#include TEXT(OF(_vectors.h))

enum { FIELDS = sizeof(OF(_sample)) / sizeof(int32_t), GOOD = 20 };

static uint64_t seed = 88172645463325252ull;

static uint32_t random_bits(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (uint32_t)(seed >> 16);
}

static uint32_t field(uint32_t calm, int storm)
{
    static const uint32_t ends[6] = {0x80000000u, 0x7FFFFFFFu, 0u, 1u, 0xFFFFFFFFu, 0x40000000u};
    uint32_t kind = random_bits() & 31u;
    if (!storm || kind > 3u) {
        return calm;
    }
    if (kind == 0u) {
        return random_bits();
    }
    if (kind == 1u) {
        return ends[random_bits() % 6u];
    }
    return (kind == 2u) ? random_bits() >> (random_bits() % 32u) : calm + (random_bits() >> 12);
}

int main(void)
{
    static OF(_state) state;
    long k, used = 0, faults = 0;
    OF(_init)(&OF(_numbers), &state);
    for (k = 0; k < SAMPLES + 300L; ++k) {
        OF(_sample) sample;
        OF(_output) output;
        int32_t *const into = &sample.dt;
        int storm = k < SAMPLES && (k / 1000) % 2;
        int i, status;
        for (i = 0; i < FIELDS; ++i) { /* the self-test's own drive over and over, turned about by the storm */
            uint32_t word = field(OF(_samples)[FIELDS * (GOOD + k % 64) + i], storm);
            into[i] = (word < 0x80000000u) ? (int32_t)word : (int32_t)(word - 0x80000000u) - 2147483647 - 1;
        }
        status = OF(_step)(&OF(_numbers), &state, &sample, &output);
        faults += status < 0 || status > 7;
        used += k >= SAMPLES && (status <= 3);
    }
    printf("%ld samples, %ld faults, %ld of the last 300 used\n", k, faults, used);
    return (faults != 0) || (used == 0) || (OF(_self_test)(0) != 0ul);
}
