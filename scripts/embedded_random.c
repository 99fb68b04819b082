/* Random samples through an exported estimator: any bits, NaN, infinities, believable values; under sanitizers.
 *
 * Built with -DNAME=bicycle_paper -DSAMPLES=1000000. Ends with 0 where every output and every real of the
 * state stayed finite and every status was one of the list, and 300 good samples after the storm are used. */

#include <stdint.h>
#include <stdio.h>

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define OF(what) JOIN(NAME, what)
#define TEXT2(a) #a
#define TEXT(a) TEXT2(a)

#include TEXT(OF(_config.h))
#include TEXT(OF(_self_test.h))

enum { FIELDS = sizeof(OF(_sample)) / sizeof(float) };
enum { OUTPUTS = sizeof(OF(_output)) / sizeof(float), STATES = sizeof(OF(_state)) / sizeof(float) };

typedef union word {
    uint32_t bits;
    float value;
} word;

static uint64_t seed = 88172645463325252ull;

static uint32_t random_bits(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (uint32_t)(seed >> 16);
}

static float between(float low, float high)
{
    return low + (high - low) * ((float)(random_bits() >> 8) / 16777216.0f);
}

/* A believable drive: input a triangle wave, speed a slow one, measurement a lag behind the input. */
static float believable(int i, long k)
{
    static float lagged = 0.0f;
    float phase = (float)(k % 61) / 61.0f;
    float input = 0.06f * ((phase < 0.5f) ? (4.0f * phase - 1.0f) : (3.0f - 4.0f * phase));
    input *= ((k / 5000) % 3 == 0) ? 0.001f : (((k / 5000) % 3 == 1) ? 1.0f : 4.0f);
    if (i == 0) {
        lagged += 0.2f * (6.0f * input - lagged);
        return between(0.0095f, 0.0105f);
    }
    if (i == 1) {
        return input;
    }
    return (i == 2) ? between(19.0f, 20.0f) + (float)((k / 700) % 9) : lagged + between(-0.004f, 0.004f);
}

static float field(int i, long k, int storm)
{
    word any;
    uint32_t kind = random_bits() & 63u;
    float calm = believable(i, k);
    if (!storm || kind > 5u) {
        return calm;
    }
    if (kind == 0u) {
        any.bits = random_bits();
        return any.value;
    }
    if (kind == 1u) {
        any.bits = 0x7FC00000u;
        return any.value;
    }
    if (kind == 2u) {
        return between(-1e4f, 1e4f);
    }
    return (kind == 3u) ? 0.0f : ((kind == 4u) ? 3.0f * calm : -calm);
}

static int is_finite(const float *values, int n)
{
    int i;
    for (i = 0; i < n; ++i) {
        if (!(values[i] - values[i] == 0.0f)) {
            return 0;
        }
    }
    return 1;
}

int main(void)
{
    static OF(_state) state;
    long k, used = 0, faults = 0;
    OF(_init)(&OF(_numbers), &state);
    for (k = 0; k < SAMPLES + 300L; ++k) {
        OF(_sample) sample;
        OF(_output) output;
        int i, status;
        for (i = 0; i < FIELDS; ++i) {
            (&sample.dt)[i] = field(i, k, k < SAMPLES && (k / 1000) % 2);
        }
#if OF(_REPORTS)
        status = OF(_step)(&OF(_numbers), &state, &sample);
        OF(_report)(&OF(_numbers), &state, &output);
#else
        status = OF(_step)(&OF(_numbers), &state, &sample, &output);
#endif
        faults += status < 0 || status > 7;
        faults += !is_finite((const float *)&output, OUTPUTS) || !is_finite((const float *)&state, STATES);
        used += k >= SAMPLES && (status <= 3);
    }
    printf("%ld samples, %ld faults, %ld of the last 300 used\n", k, faults, used);
    return (faults != 0) || (used == 0) || (OF(_self_test)(0) != 0ul);
}
