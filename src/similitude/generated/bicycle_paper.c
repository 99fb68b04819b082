/* Regression of the paper for the bicycle. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle, Brennan & Alleyne 2004, eqs 1-4
 *   base: m, L, U
 *   unknown: pi3; in proportion to it: pi4
 *   m1/T = pi1/pi5
 *   m2/T = (pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1))/pi5
 *
 * Operations: step 93 at most, 10 at least (arithmetic, comparisons, selects), init 23.
 * Memory: state 22 reals, configuration 27 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL bicycle_paper_real;
#define R(x) ((bicycle_paper_real)(x))

#if defined(__GNUC__)
#define MAGNITUDE(x) \
    ((sizeof(SIMILITUDE_REAL) == sizeof(float)) ? R(__builtin_fabsf((float)(x))) \
                                                : R(__builtin_fabs((double)(x))))
#define WITHIN(x, limit) (MAGNITUDE(x) < (limit))
#define BEYOND(x, limit) (MAGNITUDE(x) > (limit))
#else
#define WITHIN(x, limit) (((x) < (limit)) && ((x) > -(limit)))
#define BEYOND(x, limit) (((x) > (limit)) || ((x) < -(limit)))
#endif

enum bicycle_paper_status {
    BICYCLE_PAPER_OK = 0,
    BICYCLE_PAPER_NOT_EXCITED = 1,
    BICYCLE_PAPER_OUTSIDE_LINEAR = 2,
    BICYCLE_PAPER_AT_LIMIT = 3,
    BICYCLE_PAPER_NO_MEASUREMENT = 4,
    BICYCLE_PAPER_RESTARTED = 5,
    BICYCLE_PAPER_TOO_SLOW = 6,
    BICYCLE_PAPER_BAD_SAMPLE = 7
};

typedef struct bicycle_paper_config {
    bicycle_paper_real L;                            /* [m] wheelbase */
    bicycle_paper_real pi1;                          /* [-] frozen pi1 */
    bicycle_paper_real pi4_slope;                    /* [-] frozen pi4/pi3 */
    bicycle_paper_real pi5;                          /* [-] frozen pi5 */
    bicycle_paper_real sample_time;                  /* [s] sample time the filters are designed for */
    bicycle_paper_real poles_1[2];                   /* [-] first section of the high-pass: 1 + a1 + a2, a2 */
    bicycle_paper_real poles_2[2];                   /* [-] second section of the high-pass: 1 + a1 + a2, a2 */
    bicycle_paper_real pi3_start;                    /* [-] pi3 before the first update */
    bicycle_paper_real normal_start;                 /* [-] sum of squared regressors before the first update, dimensionless */
    bicycle_paper_real normal_least;                 /* [(rad/s)^2/(m^2/s^2)^2] added at each update, > 0 */
    bicycle_paper_real forgetting;                   /* [-] share of the past kept at each update */
    bicycle_paper_real dead_zone;                    /* [rad/s] |r| that must be exceeded for an update */
    bicycle_paper_real settle_samples;               /* [-] whole samples in a row before an update, 3 or more */
    bicycle_paper_real noise_variance;               /* [(rad/s)^2] least variance of r a sample, > 0 */
    bicycle_paper_real K_low;                        /* [m^2/s^2] least K that is reported, > 0 */
    bicycle_paper_real K_limit;                      /* [m^2/s^2] greatest magnitude of K */
    bicycle_paper_real variance_limit;               /* [-] greatest variance that is reported */
    bicycle_paper_real dt_low;                       /* [s] shortest step that counts as one sample */
    bicycle_paper_real dt_high;                      /* [s] longest step that counts as one sample */
    bicycle_paper_real U_least;                      /* [m/s] least forward speed to learn at, > 0 */
    bicycle_paper_real input_limit;                  /* [rad] greatest believable delta */
    bicycle_paper_real output_limit;                 /* [rad/s] greatest believable r */
    bicycle_paper_real output_jump;                  /* [rad/s] greatest believable change of r in one sample */
    bicycle_paper_real signal_limit;                 /* [m/s] greatest believable scale */
    bicycle_paper_real validity_limit;               /* [m/s^2] edge of the model's linear range */
} bicycle_paper_config;

typedef struct bicycle_paper_state {
    bicycle_paper_real from_input;                   /* [-] regressor per change of input, but for what the scale changes */
    bicycle_paper_real from_output;                  /* [-] the same per change of output */
    bicycle_paper_real theta;                        /* [m^2/s^2] K of the regression */
    bicycle_paper_real normal;                       /* [(rad/s)^2/(m^2/s^2)^2] sum of squared regressors, forgetting */
    bicycle_paper_real mean_square;                  /* [(rad/s)^2] mean square of the residual */
    bicycle_paper_real weight;                       /* [-] updates the mean square rests on */
    bicycle_paper_real information;                  /* [-] information gained about ln K */
    bicycle_paper_real log_variance;                 /* [-] variance of ln K at the last update */
    bicycle_paper_real last_input;                   /* [rad] last usable input */
    bicycle_paper_real input_change;                 /* [rad] its last change */
    bicycle_paper_real input_1;                      /* [rad] what the first section holds of it */
    bicycle_paper_real input_1_change;               /* [rad] its last change */
    bicycle_paper_real input_2;                      /* [rad] what the second section holds of it */
    bicycle_paper_real input_2_change;               /* [rad] its last change */
    bicycle_paper_real last_measured;                /* [rad/s] last usable output */
    bicycle_paper_real output_change;                /* [rad/s] its last change */
    bicycle_paper_real output_1;                     /* [rad/s] what the first section holds of it */
    bicycle_paper_real output_1_change;              /* [rad/s] its last change */
    bicycle_paper_real output_2;                     /* [rad/s] what the second section holds of it */
    bicycle_paper_real output_2_change;              /* [rad/s] its last change */
    bicycle_paper_real last_U;                       /* [m/s] last forward speed fast enough to learn */
    bicycle_paper_real wait;                         /* [-] usable samples until the filters have settled */
} bicycle_paper_state;

typedef struct bicycle_paper_sample {
    bicycle_paper_real dt;                           /* [s] time since the sample before */
    bicycle_paper_real input;                        /* [rad] road-wheel steer angle */
    bicycle_paper_real U;                            /* [m/s] forward speed */
    bicycle_paper_real measured;                     /* [rad/s] measured yaw rate */
} bicycle_paper_sample;

typedef struct bicycle_paper_output {
    bicycle_paper_real estimate;                     /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_paper_real variance;                     /* [-] variance of ln K */
    bicycle_paper_real predicted;                    /* [rad/s] yaw rate predicted before the measurement */
    bicycle_paper_real innovation;                   /* [rad/s] measured minus predicted; 0 without a measurement */
    bicycle_paper_real innovation_variance;          /* [(rad/s)^2] variance of the innovation */
    bicycle_paper_real information_gained;           /* [-] information gained about ln K so far */
    bicycle_paper_real pi3;                          /* [-] group at the last usable scale */
} bicycle_paper_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void bicycle_paper_init(const bicycle_paper_config *config, bicycle_paper_state *state)
{
    state->last_U = config->U_least;
    state->from_input = config->pi1*config->sample_time/((config->L*config->L)*config->pi5);
    state->from_output = config->sample_time*((config->pi1*config->pi1) + config->pi4_slope*((config->pi1 - R(1.0))*(config->pi1 - R(1.0))) + config->pi5*(R(1.0) + config->pi4_slope))/(config->L*config->pi5);
    state->theta = config->pi3_start*(state->last_U*state->last_U);
    state->normal = config->normal_start/((config->L*config->L)*(state->last_U*state->last_U));
    state->mean_square = R(0.0);
    state->weight = R(0.0);
    state->information = R(0.0);
    state->log_variance = config->variance_limit;
    state->last_input = R(0.0);
    state->input_change = R(0.0);
    state->input_1 = R(0.0);
    state->input_1_change = R(0.0);
    state->input_2 = R(0.0);
    state->input_2_change = R(0.0);
    state->last_measured = R(0.0);
    state->output_change = R(0.0);
    state->output_1 = R(0.0);
    state->output_1_change = R(0.0);
    state->output_2 = R(0.0);
    state->output_2_change = R(0.0);
    state->wait = R(1.0) + config->settle_samples;
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_paper_advance(const bicycle_paper_config *config, bicycle_paper_state *state,
                                     const bicycle_paper_sample *sample, bicycle_paper_output *output)
{
    bicycle_paper_real estimate = R(0.0);
    bicycle_paper_real expected = R(0.0);
    bicycle_paper_real information_gained = R(0.0);
    bicycle_paper_real innovation = R(0.0);
    bicycle_paper_real innovation_variance = R(0.0);
    bicycle_paper_real input_step = R(0.0);
    bicycle_paper_real inverse = R(0.0);
    int learnt = 0;
    bicycle_paper_real output_step = R(0.0);
    bicycle_paper_real pi3 = R(0.0);
    bicycle_paper_real predicted = R(0.0);
    bicycle_paper_real scale_now = R(0.0);
    int status = 0;
    bicycle_paper_real variance = R(0.0);
    bicycle_paper_real waiting = R(0.0);
    bicycle_paper_real y_now = R(0.0);

    waiting = state->wait;
    status = 1;
    if (!((sample->dt < config->dt_high) && (sample->dt > config->dt_low))) { /* the sample before is elsewhere */
        if ((sample->dt < R(1000000.0)) && (sample->dt > R(0.0))) { /* time must advance */
            if (waiting <= config->settle_samples) {
                status = 5;
            }
            waiting = R(1.0) + config->settle_samples;
        } else {
            status = 7;
        }
    }
    if (status < 7) {
        if ((WITHIN(sample->U, config->signal_limit)) && (WITHIN(sample->input, config->input_limit))) { /* a missing input or scale is held */
            input_step = sample->input - state->last_input;
            state->last_input = sample->input;
            scale_now = sample->U;
        } else {
            input_step = R(0.0);
            scale_now = state->last_U;
            status = 4;
        }
        if (((WITHIN(state->last_measured - sample->measured, config->output_jump)) || (waiting > config->settle_samples)) && (WITHIN(sample->measured, config->output_limit))) { /* so is an output */
            output_step = sample->measured - state->last_measured;
            y_now = sample->measured;
        } else {
            output_step = R(0.0);
            y_now = state->last_measured;
            status = 4;
        }
        if ((status < 5) && (status > 3)) {
            waiting = R(1.0) + config->settle_samples;
        } else {
            if (waiting > R(0.5)) { /* usable samples in a row */
                waiting = waiting - R(1.0);
            }
        }
        if (scale_now <= config->U_least) { /* too slow to see the dynamics */
            scale_now = state->last_U;
            waiting = ((R(1.0)) > (waiting) ? R(1.0) : waiting);
            if (status < 2) {
                status = 6;
            }
        }
        state->last_U = scale_now;
        state->last_measured = y_now;
        state->wait = waiting;
        inverse = (R(1.0)/scale_now);
        const bicycle_paper_real input_bend = input_step - state->input_change; /* second difference */
        state->input_change = input_step;
        const bicycle_paper_real input_1_now = input_bend + state->input_1_change*config->poles_1[1] - state->input_1*config->poles_1[0];
        const bicycle_paper_real input_bend_1 = input_1_now - state->input_1_change;
        state->input_1 = state->input_1 + input_1_now;
        state->input_1_change = input_1_now;
        const bicycle_paper_real input_2_now = input_bend_1 + state->input_2_change*config->poles_2[1] - state->input_2*config->poles_2[0];
        const bicycle_paper_real output_bend = output_step - state->output_change; /* second difference */
        state->output_change = output_step;
        const bicycle_paper_real output_1_now = output_bend + state->output_1_change*config->poles_1[1] - state->output_1*config->poles_1[0];
        const bicycle_paper_real output_bend_1 = output_1_now - state->output_1_change;
        state->output_1 = state->output_1 + output_1_now;
        state->output_1_change = output_1_now;
        const bicycle_paper_real output_2_now = output_bend_1 + state->output_2_change*config->poles_2[1] - state->output_2*config->poles_2[0];
        const bicycle_paper_real phi = state->from_input*state->input_2_change - state->from_output*inverse*state->output_2_change; /* regressor, eqs 25-26 */
        expected = phi*state->theta;
        const bicycle_paper_real y = output_2_now - state->output_2_change; /* second difference, eq 24 */
        const bicycle_paper_real residual = y - expected;
        predicted = y_now - residual; /* the newest output has weight one in y */
        if ((BEYOND(y_now, config->dead_zone)) && (waiting < R(0.5))) { /* outside the dead zone, filters settled */
            innovation = residual;
            learnt = 1;
            state->normal = config->normal_least + (phi*phi) + config->forgetting*state->normal;
            const bicycle_paper_real moved = state->theta + phi*residual/state->normal;
            if (WITHIN(moved, config->K_limit)) {
                state->theta = moved;
            } else {
                state->theta = (moved > R(0.0) ? config->K_limit : (-config->K_limit));
            }
            state->weight = R(1.0) + config->forgetting*state->weight;
            state->mean_square = state->mean_square + ((residual*residual) - state->mean_square)/state->weight;
            status = 0;
            if (BEYOND(scale_now*y_now, config->validity_limit)) {
                status = 2;
            }
        } else {
            learnt = 0;
            innovation = (config->settle_samples >= waiting ? residual : R(0.0));
            if (state->weight < R(0.5)) { /* nothing was learnt yet */
                state->theta = config->pi3_start*(scale_now*scale_now);
                state->normal = config->normal_start/((config->L*config->L)*(scale_now*scale_now));
            }
        }
        state->input_2 = state->input_2 + input_2_now;
        state->input_2_change = input_2_now;
        state->output_2 = state->output_2 + output_2_now;
        state->output_2_change = output_2_now;
    } else {
        predicted = state->last_measured;
        expected = R(0.0);
        innovation = R(0.0);
        learnt = 0;
        inverse = (R(1.0)/state->last_U);
    }
    if (state->theta > config->K_low) { /* no stiffness is zero or less */
        estimate = state->theta;
    } else {
        estimate = config->K_low;
        if (((status < 3) && (status > 1)) || (status < 1)) {
            status = 3;
        }
    }
    pi3 = estimate*(inverse*inverse);
    innovation_variance = ((state->mean_square) > (config->noise_variance) ? state->mean_square : config->noise_variance); /* never below the sensor's share */
    if (learnt > 0) { /* nothing was learnt: nothing is known otherwise than before */
        state->information = state->information + (expected*expected)/innovation_variance;
        const bicycle_paper_real scatter = innovation_variance/((estimate*estimate)*state->normal);
        state->log_variance = ((scatter) < (config->variance_limit) ? scatter : config->variance_limit);
    }
    information_gained = state->information;
    variance = state->log_variance;

    output->estimate = estimate;
    output->variance = variance;
    output->predicted = predicted;
    output->innovation = innovation;
    output->innovation_variance = innovation_variance;
    output->information_gained = information_gained;
    output->pi3 = pi3;
    return status;
}

/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int bicycle_paper_step(const bicycle_paper_config *config, bicycle_paper_state *state,
                               const bicycle_paper_sample *sample, bicycle_paper_output *output)
{
    return bicycle_paper_advance(config, state, sample, output);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long bicycle_paper_batch(const bicycle_paper_config *config, bicycle_paper_state *state, long n,
                                 const bicycle_paper_sample *samples, bicycle_paper_output *outputs, int *status)
{
    bicycle_paper_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = bicycle_paper_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}
