/* Written by hand, to weigh the generated code against: a textbook recursive least squares, and the
 * paper's regression as a C programmer would write it. Same compiler, same flags as the generated.
 *
 * The regression takes what `bicycle_paper` takes and gives what it gives, but what does not change
 * during a log is worked out once, the state lives in a local struct, flags are integers, and each
 * reciprocal is taken once. Brennan & Alleyne 2004, eqs 22-26 and section 6.
 */

#define API __attribute__((visibility("default")))

/* Scalar recursive least squares with forgetting; theta is stored for every sample. */
API void reference_rls(double forgetting, double P, long n, const double *phi, const double *y,
                       double *theta_out)
{
    double theta = 0.0;
    for (long i = 0; i < n; ++i) {
        const double f = phi[i];
        const double gain = P * f / (forgetting + f * P * f);
        theta += gain * (y[i] - f * theta);
        P = (1.0 - gain * f) * P / forgetting;
        theta_out[i] = theta;
    }
}

enum status { OK, NOT_EXCITED, OUTSIDE_LINEAR, AT_LIMIT, NO_MEASUREMENT, RESTARTED, TOO_SLOW, BAD_SAMPLE };

typedef struct { double b0, b1, b2, a1, a2; } biquad;
typedef struct { double first, second; } memory;
typedef struct { double dt, steer, U, yaw_rate; } sample;

typedef struct {
    double K, ln_K_variance, predicted, innovation, innovation_variance, information, pi3;
} output;

typedef struct {
    double L, pi1, pi4_slope, pi5, sample_time;
    biquad section[2];
    double pi3_start, P_start, forgetting, dead_zone, settle_samples, noise_variance;
    double K_low, K_limit, variance_limit, dt_low, dt_high, U_least;
    double steer_limit, yaw_limit, yaw_jump, U_limit, validity_limit;
} config;

/* What follows from the configuration and stays the same for the whole log. */
typedef struct {
    double m1_per_U, m2, inv_L, direct, inv_direct, inv_forgetting, least_spread, validity_square;
    long settle;
} constants;

typedef struct {
    double theta, P, mean_square, weight, information;
    memory steer[2], yaw[2];
    double steer_before[2], yaw_before[2]; /* filtered, one and two samples ago */
    double last_steer, last_yaw, last_U;
    long fresh;
} state;

static inline double filter(const biquad *q, memory *m, double x)
{
    const double y = q->b0 * x + m->first;
    m->first = q->b1 * x - q->a1 * y + m->second;
    m->second = q->b2 * x - q->a2 * y;
    return y;
}

static inline double clamp(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

static constants prepare(const config *c)
{
    const double rear = (1.0 - c->pi1) * (1.0 - c->pi1) * c->pi4_slope;
    constants k;
    k.inv_L = 1.0 / c->L;
    k.m1_per_U = c->pi1 / c->pi5 * c->sample_time * k.inv_L;
    k.m2 = (1.0 + c->pi4_slope + (c->pi1 * c->pi1 + rear) / c->pi5) * c->sample_time;
    k.direct = c->section[0].b0 * c->section[1].b0;
    k.inv_direct = 1.0 / k.direct;
    k.inv_forgetting = 1.0 / c->forgetting;
    k.least_spread = c->noise_variance * k.direct * k.direct;
    k.validity_square = c->validity_limit * c->validity_limit;
    k.settle = (long)c->settle_samples;
    return k;
}

/* One update of the regression; returns the sample's status. */
static inline int learn(const config *c, const constants *k, state *s, double phi, double y,
                        double least_spread, double yaw_rate)
{
    const double residual = y - phi * s->theta;
    const double gain = s->P * phi / (c->forgetting + phi * phi * s->P);
    const double explained = phi * s->theta;
    const double ay = s->last_U * yaw_rate;
    s->weight = c->forgetting * s->weight + 1.0;
    s->mean_square += (residual * residual - s->mean_square) / s->weight;
    s->information +=
        explained * explained / (s->mean_square > least_spread ? s->mean_square : least_spread);
    s->theta = clamp(s->theta + gain * residual, -c->K_limit, c->K_limit);
    s->P = (1.0 - gain * phi) * s->P * k->inv_forgetting;
    if (s->theta <= c->K_low)
        return AT_LIMIT;
    return ay * ay > k->validity_square ? OUTSIDE_LINEAR : OK;
}

static inline int advance(const config *c, const constants *k, state *s, const sample *in, output *out)
{
    int status = NOT_EXCITED, usable = 1, live = 1;
    double steer = in->steer, U = in->U, yaw = in->yaw_rate;
    const double change = yaw - s->last_yaw;
    /* The limits are written so that a NaN fails them. */
    if (!(U < c->U_limit && U > -c->U_limit && steer < c->steer_limit && steer > -c->steer_limit)) {
        steer = s->last_steer;
        U = s->last_U;
        usable = 0;
    }
    if (!(yaw < c->yaw_limit && yaw > -c->yaw_limit)
        || (s->fresh > 0 && (change > c->yaw_jump || change < -c->yaw_jump))) {
        yaw = s->last_yaw;
        usable = 0;
    }
    if (U > c->U_least) {
        s->last_U = U;
    } else {
        live = 0;
        status = TOO_SLOW;
    }
    if (s->fresh > 0 && !(in->dt > c->dt_low && in->dt < c->dt_high)) {
        s->fresh = 0;
        status = RESTARTED;
    }
    if (usable) {
        s->fresh = (s->fresh < k->settle ? s->fresh : k->settle) + 1;
    } else {
        s->fresh = 0;
        status = NO_MEASUREMENT;
    }
    const double phi = (k->m2 / s->last_U * (s->yaw_before[1] - s->yaw_before[0])
                        + k->m1_per_U * (s->steer_before[0] - s->steer_before[1])) * k->inv_L;
    const double expected = 2.0 * s->yaw_before[0] - s->yaw_before[1] + phi * s->theta;
    const double rest = c->section[1].b0 * s->yaw[0].first + s->yaw[1].first;
    out->predicted = (expected - rest) * k->inv_direct;
    out->innovation = usable ? yaw - out->predicted : 0.0;

    const double steer_filtered =
        filter(&c->section[1], &s->steer[1], filter(&c->section[0], &s->steer[0], steer));
    const double yaw_filtered =
        filter(&c->section[1], &s->yaw[1], filter(&c->section[0], &s->yaw[0], yaw));
    if (live && s->fresh > k->settle && (yaw > c->dead_zone || yaw < -c->dead_zone)) {
        const double y = yaw_filtered - 2.0 * s->yaw_before[0] + s->yaw_before[1];
        status = learn(c, k, s, phi, y, k->least_spread, yaw);
    } else if (s->weight < 0.5) { /* nothing was learnt yet: the start is one of pi3 */
        s->theta = c->pi3_start * s->last_U * s->last_U;
        s->P = c->P_start * c->L * c->L * s->last_U * s->last_U;
    }
    s->yaw_before[1] = s->yaw_before[0];
    s->yaw_before[0] = yaw_filtered;
    s->steer_before[1] = s->steer_before[0];
    s->steer_before[0] = steer_filtered;
    s->last_steer = steer;
    s->last_yaw = yaw;
    return status;
}

static inline void report(const config *c, const constants *k, const state *s, output *out)
{
    const double K = s->theta > c->K_low ? s->theta : c->K_low;
    const double square = k->inv_direct * k->inv_direct;
    const double spread = s->mean_square * square;
    out->pi3 = K / (s->last_U * s->last_U);
    out->K = K;
    out->innovation_variance = spread > c->noise_variance ? spread : c->noise_variance;
    out->information = s->information;
    out->ln_K_variance = c->variance_limit;
    if (s->weight > 0.5) {
        const double variance = s->P * out->innovation_variance / (K * K * square);
        if (variance < c->variance_limit)
            out->ln_K_variance = variance;
    }
}

/* The regression over a log. */
API void reference_paper(const config *c, long n, const sample *in, output *out, int *status)
{
    const constants k = prepare(c);
    state s = {.last_U = c->U_least};
    for (long i = 0; i < n; ++i) {
        if (in[i].dt > 0.0 && in[i].dt < 1e6) {
            status[i] = advance(c, &k, &s, &in[i], &out[i]);
        } else {
            out[i].predicted = s.last_yaw;
            out[i].innovation = 0.0;
            status[i] = BAD_SAMPLE;
        }
        report(c, &k, &s, &out[i]);
    }
}
