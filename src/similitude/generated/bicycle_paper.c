/* Regression of the paper for the bicycle. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle, Brennan & Alleyne 2004, eqs 1-4
 *   base: m, L, U
 *   unknown: pi3; in proportion to it: pi4
 *   m1/T = pi1/pi5
 *   m2/T = (pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1))/pi5
 *
 * Operations: step 64 at most, 3 at least (arithmetic, comparisons, selects), report 16, init 0.
 * Memory: state 19 reals, configuration 24 reals; no heap, no globals, no libm, C99.
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
    bicycle_paper_real input_ratio;                  /* [(rad/s)/(rad)/(m/s)] b1 over a1 + 2: pi1/(L*(pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1))) */
    bicycle_paper_real K_per_theta;                  /* [(m^2/s^2)/(m/s)] L*pi5/(sample_time*(pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1))) */
    bicycle_paper_real poles_1[2];                   /* [-] first section of the high-pass: 1 + a1 + a2, a2 */
    bicycle_paper_real poles_2[2];                   /* [-] second section of the high-pass: 1 + a1 + a2, a2 */
    bicycle_paper_real theta_start;                  /* [m/s] theta before the first update */
    bicycle_paper_real normal_start;                 /* [(rad/s)^2/(m/s)^2] sum of squared regressors before it, > 0 */
    bicycle_paper_real normal_least;                 /* [(rad/s)^2/(m/s)^2] added to it at each update, > 0 */
    bicycle_paper_real forgetting;                   /* [-] share of the past kept at each update */
    bicycle_paper_real dead_zone;                    /* [rad/s] |r| that must be exceeded for an update */
    bicycle_paper_real settle_samples;               /* [-] usable samples in a row until one may update, itself included, 4 or more */
    bicycle_paper_real noise_variance;               /* [(rad/s)^2] least variance of r a sample, > 0 */
    bicycle_paper_real theta_low;                    /* [m/s] least theta that is reported, > 0 */
    bicycle_paper_real theta_limit;                  /* [m/s] greatest magnitude of theta */
    bicycle_paper_real variance_limit;               /* [-] greatest variance that is reported */
    bicycle_paper_real sample_time;                  /* [s] sample time the filters are designed for */
    bicycle_paper_real dt_room;                      /* [s] a step that is this much off is not one sample */
    bicycle_paper_real U_least;                      /* [m/s] least forward speed to learn at, > 0 */
    bicycle_paper_real input_limit;                  /* [rad] greatest believable delta */
    bicycle_paper_real output_limit;                 /* [rad/s] greatest believable r */
    bicycle_paper_real output_jump;                  /* [rad/s] greatest believable change of r in one sample */
    bicycle_paper_real signal_limit;                 /* [m/s] greatest believable scale */
    bicycle_paper_real validity_limit;               /* [m/s^2] edge of the model's linear range */
} bicycle_paper_config;

typedef struct bicycle_paper_state {
    bicycle_paper_real theta;                        /* [m/s] (a1 + 2) U, in proportion to K */
    bicycle_paper_real normal;                       /* [(rad/s)^2/(m/s)^2] sum of squared regressors, forgetting */
    bicycle_paper_real square_sum;                   /* [(rad/s)^2] sum of squared residuals, forgetting */
    bicycle_paper_real weight;                       /* [-] updates it rests on, forgetting */
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
    bicycle_paper_real wait;                         /* [-] usable samples until the filters have settled, 0 and less: they have */
    bicycle_paper_real residual;                     /* [rad/s] by how much the newest output was predicted wrong */
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
    bicycle_paper_real pi3;                          /* [-] group at the last usable scale */
} bicycle_paper_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void bicycle_paper_init(const bicycle_paper_config *config, bicycle_paper_state *state)
{
    state->theta = config->theta_start;
    state->normal = config->normal_start;
    state->square_sum = config->noise_variance;
    state->weight = R(1.0);
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
    state->last_U = config->U_least;
    state->wait = config->settle_samples;
    state->residual = R(0.0);
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_paper_advance(const bicycle_paper_config *config, bicycle_paper_state *state,
                                     const bicycle_paper_sample *sample)
{
    bicycle_paper_real input_step = R(0.0);
    bicycle_paper_real output_step = R(0.0);
    bicycle_paper_real scale_now = R(0.0);
    int status = 0;
    bicycle_paper_real waiting = R(0.0);
    bicycle_paper_real y_now = R(0.0);

    waiting = state->wait;
    status = 1;
    if (!(WITHIN(sample->dt - config->sample_time, config->dt_room))) { /* else the sample before is elsewhere */
        if ((sample->dt < R(1000000.0)) && (sample->dt > R(0.0))) { /* time must advance */
            status = 5;
            waiting = config->settle_samples;
        } else {
            status = 7;
        }
    }
    if (status < 7) {
        if (((WITHIN(state->last_measured - sample->measured, config->output_jump)) || (waiting >= config->settle_samples)) && (WITHIN(sample->measured, config->output_limit))) { /* a missing output is held */
            output_step = sample->measured - state->last_measured;
            y_now = sample->measured;
        } else {
            output_step = R(0.0);
            y_now = state->last_measured;
            status = 4;
            waiting = R(1.0) + config->settle_samples;
        }
        if ((WITHIN(sample->U, config->signal_limit)) && (WITHIN(sample->input, config->input_limit))) { /* so is an input or a scale */
            input_step = sample->input - state->last_input;
            state->last_input = sample->input;
            scale_now = sample->U;
        } else {
            input_step = R(0.0);
            scale_now = state->last_U;
            status = 4;
            waiting = R(1.0) + config->settle_samples;
        }
        waiting = waiting - R(1.0); /* usable samples in a row */
        if (scale_now <= config->U_least) { /* too slow to see the dynamics */
            scale_now = state->last_U;
            waiting = config->settle_samples;
            if (status < 2) {
                status = 6;
            }
        }
        state->last_U = scale_now;
        state->last_measured = y_now;
        state->wait = waiting;
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
        const bicycle_paper_real phi = state->input_2_change*config->input_ratio - state->output_2_change/scale_now; /* regressor, eqs 25-26 */
        const bicycle_paper_real y = output_2_now - state->output_2_change; /* second difference, eq 24 */
        state->residual = y - phi*state->theta;
        if ((BEYOND(y_now, config->dead_zone)) && (waiting <= R(0.0))) { /* outside the dead zone, filters settled */
            state->normal = config->normal_least + (phi*phi) + config->forgetting*state->normal;
            const bicycle_paper_real moved = state->theta + phi*state->residual/state->normal;
            if (WITHIN(moved, config->theta_limit)) { /* as far as any car */
                state->theta = moved;
            }
            state->weight = R(1.0) + config->forgetting*state->weight;
            state->square_sum = (state->residual*state->residual) + config->forgetting*state->square_sum;
            status = 0;
            if (BEYOND(scale_now*y_now, config->validity_limit)) {
                status = 2;
            }
            if (state->theta <= config->theta_low) { /* no stiffness is zero or less */
                status = 3;
            }
        }
        state->input_2 = state->input_2 + input_2_now;
        state->input_2_change = input_2_now;
        state->output_2 = state->output_2 + output_2_now;
        state->output_2_change = output_2_now;
    } else {
        state->residual = R(0.0);
    }

    return status;
}

/* Every output, from the state as it is: at any time between two steps. */
SIMILITUDE_API void bicycle_paper_report(const bicycle_paper_config *config, const bicycle_paper_state *state,
                                  bicycle_paper_output *output)
{
    bicycle_paper_real estimate = R(0.0);
    bicycle_paper_real innovation = R(0.0);
    bicycle_paper_real innovation_variance = R(0.0);
    bicycle_paper_real pi3 = R(0.0);
    bicycle_paper_real predicted = R(0.0);
    bicycle_paper_real variance = R(0.0);

    const bicycle_paper_real told = ((state->theta) > (config->theta_low) ? state->theta : config->theta_low); /* no stiffness is zero or less */
    estimate = config->K_per_theta*told;
    pi3 = estimate/((state->last_U*state->last_U));
    const bicycle_paper_real mean_square = state->square_sum/state->weight;
    innovation_variance = ((mean_square) > (config->noise_variance) ? mean_square : config->noise_variance); /* never below the sensor's share */
    const bicycle_paper_real scatter = innovation_variance/(state->normal*(told*told));
    variance = ((scatter) < (config->variance_limit) ? scatter : config->variance_limit);
    predicted = state->last_measured - state->residual;
    innovation = (config->settle_samples > state->wait ? state->residual : R(0.0));

    output->estimate = estimate;
    output->variance = variance;
    output->predicted = predicted;
    output->innovation = innovation;
    output->innovation_variance = innovation_variance;
    output->pi3 = pi3;
}

/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int bicycle_paper_step(const bicycle_paper_config *config, bicycle_paper_state *state,
                               const bicycle_paper_sample *sample)
{
    return bicycle_paper_advance(config, state, sample);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long bicycle_paper_batch(const bicycle_paper_config *config, bicycle_paper_state *state, long n,
                                 const bicycle_paper_sample *samples, bicycle_paper_output *outputs, int *status)
{
    bicycle_paper_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        {
            status[i] = bicycle_paper_advance(config, &now, &samples[i]);
            bicycle_paper_report(config, &now, &outputs[i]);
        }
    *state = now;
    return n;
}
