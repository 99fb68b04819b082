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
    double K, ln_K_variance, predicted, innovation, innovation_variance, pi3;
} output;

typedef struct {
    double input_ratio, K_per_theta;
    poles section[2];
    double theta_start, normal_start, normal_least, forgetting, dead_zone, settle_samples, noise_variance;
    double theta_low, theta_limit, variance_limit, sample_time, dt_room, U_least;
    double steer_limit, yaw_limit, yaw_jump, U_limit, validity_limit;
} config;

/* What follows from the configuration and stays the same for the whole log. */
typedef struct {
    double validity_square, shortest, longest;
    long settle;
} constants;

/* A signal behind the high-pass: its last value and change, then what each section holds and its last change. */
typedef struct { double last, change, held[2], moved[2]; } memory;

typedef struct {
    double theta, normal, mean_square, weight, last_U;
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

static constants prepare(const config *c)
{
    constants k;
    k.validity_square = c->validity_limit * c->validity_limit;
    k.shortest = c->sample_time - c->dt_room;
    k.longest = c->sample_time + c->dt_room;
    k.settle = (long)c->settle_samples;
    return k;
}

/* One update of the regression; returns the sample's status. */
static inline int learn(const config *c, const constants *k, state *s, double phi, double residual)
{
    const double ay = s->last_U * s->yaw.last;
    s->normal = c->forgetting * s->normal + phi * phi + c->normal_least;
    const double moved = s->theta + phi * residual / s->normal;
    if (moved < c->theta_limit && moved > -c->theta_limit)
        s->theta = moved;
    s->weight = c->forgetting * s->weight + 1.0;
    s->mean_square += (residual * residual - s->mean_square) / s->weight;
    if (s->theta <= c->theta_low)
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
    if (!(in->dt > k->shortest && in->dt < k->longest)) {
        s->fresh = 0;
        status = RESTARTED;
    }
    if (usable) {
        s->fresh = (s->fresh < k->settle ? s->fresh : k->settle) + 1;
    } else {
        s->fresh = 0;
        status = NO_MEASUREMENT;
    }
    if (U > c->U_least) {
        s->last_U = U;
    } else {
        s->fresh = 0;
        status = status == NOT_EXCITED ? TOO_SLOW : status;
    }
    const double moved = s->yaw.moved[1];
    const double phi = c->input_ratio * s->steer.moved[1] - moved / s->last_U;
    filter(c->section, &s->steer, steer - s->steer.last);
    const double y = filter(c->section, &s->yaw, yaw - s->yaw.last) - moved;
    s->steer.last = steer;
    s->yaw.last = yaw;
    const double residual = y - phi * s->theta;
    out->predicted = yaw - residual; /* the newest yaw rate has weight one in y */
    out->innovation = s->fresh > 0 ? residual : 0.0;
    if (s->fresh >= k->settle && (yaw > c->dead_zone || yaw < -c->dead_zone))
        status = learn(c, k, s, phi, residual);
    return status;
}

static inline void report(const config *c, const state *s, output *out)
{
    const double theta = s->theta > c->theta_low ? s->theta : c->theta_low;
    out->K = theta * c->K_per_theta;
    out->pi3 = out->K / (s->last_U * s->last_U);
    out->innovation_variance = s->mean_square > c->noise_variance ? s->mean_square : c->noise_variance;
    const double variance = out->innovation_variance / (s->normal * theta * theta);
    out->ln_K_variance = variance < c->variance_limit ? variance : c->variance_limit;
}

/* The regression over a log. */
API void reference_paper(const config *c, long n, const sample *in, output *out, int *status)
{
    const constants k = prepare(c);
    state s = {.last_U = c->U_least,
               .theta = c->theta_start,
               .normal = c->normal_start,
               .mean_square = c->noise_variance,
               .weight = 1.0};
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
