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

typedef struct { double sum, a2; } poles; /* 1 + a1 + a2 and a2 of a section whose zeros are both at one */
typedef struct { double dt, steer, U, yaw_rate; } sample;

typedef struct {
    double K, ln_K_variance, predicted, innovation, innovation_variance, information, pi3;
} output;

typedef struct {
    double L, pi1, pi4_slope, pi5, sample_time;
    poles section[2];
    double pi3_start, normal_start, normal_least, forgetting, dead_zone, settle_samples, noise_variance;
    double K_low, K_limit, variance_limit, dt_low, dt_high, U_least;
    double steer_limit, yaw_limit, yaw_jump, U_limit, validity_limit;
} config;

/* What follows from the configuration and stays the same for the whole log. */
typedef struct {
    double per_steer, per_yaw, normal_start, validity_square;
    long settle;
} constants;

/* A signal behind the high-pass: its last value and change, then what each section holds and its last change. */
typedef struct { double last, change, held[2], moved[2]; } memory;

typedef struct {
    double theta, normal, mean_square, weight, information, last_U;
    memory steer, yaw;
    long fresh;
} state;

/* The newest change of the filtered signal; the high-pass is run on differences, which round the least. */
static inline double filter(const poles *section, memory *m, double step)
{
    double bend = step - m->change;
    m->change = step;
    const double first = bend + m->moved[0] * section[0].a2 - m->held[0] * section[0].sum;
    bend = first - m->moved[0];
    m->held[0] += first;
    m->moved[0] = first;
    const double second = bend + m->moved[1] * section[1].a2 - m->held[1] * section[1].sum;
    m->held[1] += second;
    m->moved[1] = second;
    return second;
}

static inline double clamp(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

static constants prepare(const config *c)
{
    const double rear = (1.0 - c->pi1) * (1.0 - c->pi1) * c->pi4_slope;
    constants k;
    k.per_steer = c->pi1 * c->sample_time / (c->L * c->L * c->pi5);
    k.per_yaw = (1.0 + c->pi4_slope + (c->pi1 * c->pi1 + rear) / c->pi5) * c->sample_time / c->L;
    k.normal_start = c->normal_start / (c->L * c->L);
    k.validity_square = c->validity_limit * c->validity_limit;
    k.settle = (long)c->settle_samples;
    return k;
}

/* One update of the regression; returns the sample's status. */
static inline int learn(const config *c, const constants *k, state *s, double phi, double residual)
{
    const double explained = phi * s->theta;
    const double ay = s->last_U * s->yaw.last;
    const double spread = c->noise_variance;
    s->normal = c->forgetting * s->normal + phi * phi + c->normal_least;
    s->theta = clamp(s->theta + phi * residual / s->normal, -c->K_limit, c->K_limit);
    s->weight = c->forgetting * s->weight + 1.0;
    s->mean_square += (residual * residual - s->mean_square) / s->weight;
    s->information += explained * explained / (s->mean_square > spread ? s->mean_square : spread);
    if (s->theta <= c->K_low)
        return AT_LIMIT;
    return ay * ay > k->validity_square ? OUTSIDE_LINEAR : OK;
}

static inline int advance(const config *c, const constants *k, state *s, const sample *in, output *out)
{
    int status = NOT_EXCITED, usable = 1, live = 1;
    double steer = in->steer, U = in->U, yaw = in->yaw_rate;
    const double change = yaw - s->yaw.last;
    /* The limits are written so that a NaN fails them. */
    if (!(U < c->U_limit && U > -c->U_limit && steer < c->steer_limit && steer > -c->steer_limit)) {
        steer = s->steer.last;
        U = s->last_U;
        usable = 0;
    }
    if (!(yaw < c->yaw_limit && yaw > -c->yaw_limit)
        || (s->fresh > 0 && (change > c->yaw_jump || change < -c->yaw_jump))) {
        yaw = s->yaw.last;
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
    const double moved = s->yaw.moved[1];
    const double phi = k->per_steer * s->steer.moved[1] - k->per_yaw / s->last_U * moved;
    filter(c->section, &s->steer, steer - s->steer.last);
    const double y = filter(c->section, &s->yaw, yaw - s->yaw.last) - moved;
    s->steer.last = steer;
    s->yaw.last = yaw;
    const double residual = y - phi * s->theta;
    out->predicted = yaw - residual; /* the newest yaw rate has weight one in y */
    out->innovation = usable ? residual : 0.0;
    if (live && s->fresh > k->settle && (yaw > c->dead_zone || yaw < -c->dead_zone)) {
        status = learn(c, k, s, phi, residual);
    } else if (s->weight < 0.5) { /* nothing was learnt yet: the start is one of pi3 */
        s->theta = c->pi3_start * s->last_U * s->last_U;
        s->normal = k->normal_start / (s->last_U * s->last_U);
    }
    return status;
}

static inline void report(const config *c, const state *s, output *out)
{
    const double K = s->theta > c->K_low ? s->theta : c->K_low;
    out->pi3 = K / (s->last_U * s->last_U);
    out->K = K;
    out->innovation_variance = s->mean_square > c->noise_variance ? s->mean_square : c->noise_variance;
    out->information = s->information;
    out->ln_K_variance = c->variance_limit;
    if (s->weight > 0.5) {
        const double variance = out->innovation_variance / (s->normal * K * K);
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
            out[i].predicted = s.yaw.last;
            out[i].innovation = 0.0;
            status[i] = BAD_SAMPLE;
        }
        report(c, &s, &out[i]);
    }
}
