/* Kalman filter of one unknown for the bicycle. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle, Brennan & Alleyne 2004, eqs 1-4
 *   base: m, L, U
 *   unknown: K; frozen: pi1, eta, rho
 *
 * Operations: step 207 at most, 8 at least (arithmetic, comparisons, selects), init 31.
 * Memory: state 22 reals, configuration 29 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL bicycle_scalar_population_real;
#define R(x) ((bicycle_scalar_population_real)(x))

enum bicycle_scalar_population_status {
    BICYCLE_SCALAR_POPULATION_OK = 0,
    BICYCLE_SCALAR_POPULATION_NOT_EXCITED = 1,
    BICYCLE_SCALAR_POPULATION_OUTSIDE_LINEAR = 2,
    BICYCLE_SCALAR_POPULATION_AT_LIMIT = 3,
    BICYCLE_SCALAR_POPULATION_NO_MEASUREMENT = 4,
    BICYCLE_SCALAR_POPULATION_RESTARTED = 5,
    BICYCLE_SCALAR_POPULATION_TOO_SLOW = 6,
    BICYCLE_SCALAR_POPULATION_BAD_SAMPLE = 7
};

typedef struct bicycle_scalar_population_config {
    bicycle_scalar_population_real L;                /* [m] wheelbase */
    bicycle_scalar_population_real pi1;              /* [-] frozen a/L, position of the centre of gravity */
    bicycle_scalar_population_real eta;              /* [-] frozen rear over front cornering coefficient; > 1 understeers */
    bicycle_scalar_population_real rho;              /* [-] frozen Iz/(m a b), yaw inertia ratio */
    bicycle_scalar_population_real sample_time;      /* [s] time between samples */
    bicycle_scalar_population_real K_start;          /* [m^2/s^2] K before the first update */
    bicycle_scalar_population_real K_low;            /* [m^2/s^2] least K of the population */
    bicycle_scalar_population_real K_high;           /* [m^2/s^2] greatest K of the population */
    bicycle_scalar_population_real start_variance;   /* [-] variance of ln K of the population */
    bicycle_scalar_population_real frozen_variance;  /* [-] what the frozen unknowns' spread adds to it */
    bicycle_scalar_population_real noise_variance;   /* [(rad/s)^2] white noise of r a sample, > 0 */
    bicycle_scalar_population_real drift;            /* [1/s] diffusion of ln K */
    bicycle_scalar_population_real structure_time;   /* [s] how long an error of the model lasts */
    bicycle_scalar_population_real scatter_rate;     /* [1/s] averaging rate of the error's mean square */
    bicycle_scalar_population_real offset_rate;      /* [1/s] rate at which offsets are followed and taken out */
    bicycle_scalar_population_real observer_rate;    /* [1/s] pull of the model towards the measurement */
    bicycle_scalar_population_real move_limit;       /* [-] greatest move of ln K in one sample */
    bicycle_scalar_population_real excitation_least; /* [-] least mean square of the sensitivity to learn from, in its units */
    bicycle_scalar_population_real excitation_rate;  /* [1/s] averaging rate of that mean square */
    bicycle_scalar_population_real variance_limit;   /* [-] greatest variance that is reported */
    bicycle_scalar_population_real settle_samples;   /* [-] whole samples in a row before an update, 3 or more */
    bicycle_scalar_population_real dt_low;           /* [s] shortest step that counts as one sample */
    bicycle_scalar_population_real dt_high;          /* [s] longest step that counts as one sample */
    bicycle_scalar_population_real U_least;          /* [m/s] least forward speed to learn at, > 0 */
    bicycle_scalar_population_real input_limit;      /* [rad] greatest believable delta */
    bicycle_scalar_population_real output_limit;     /* [rad/s] greatest believable r */
    bicycle_scalar_population_real output_jump;      /* [rad/s] greatest believable change of r in one sample */
    bicycle_scalar_population_real signal_limit;     /* [m/s] greatest believable scale */
    bicycle_scalar_population_real validity_limit;   /* [m/s^2] edge of the model's linear range */
} bicycle_scalar_population_config;

typedef struct bicycle_scalar_population_state {
    bicycle_scalar_population_real K;                /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_scalar_population_real p;                /* [-] variance of ln K */
    bicycle_scalar_population_real input_gain;       /* [-] input gain of the model */
    bicycle_scalar_population_real damping;          /* [-] damping of the model */
    bicycle_scalar_population_real stiffness;        /* [-] stiffness of the model */
    bicycle_scalar_population_real pair_output;      /* [-] pair output of the model */
    bicycle_scalar_population_real pair_input;       /* [-] pair input of the model */
    bicycle_scalar_population_real inv_interval;     /* [1/s] 1/sample time */
    bicycle_scalar_population_real y;                /* [rad/s] r of the model */
    bicycle_scalar_population_real w;                /* [rad/s/s] what the other state adds to its rate */
    bicycle_scalar_population_real y_slope;          /* [rad/s] sensitivity of y to ln K */
    bicycle_scalar_population_real w_slope;          /* [rad/s/s] the same of w */
    bicycle_scalar_population_real error_offset;     /* [rad/s] slow part of the error */
    bicycle_scalar_population_real slope_offset;     /* [rad/s] slow part of the sensitivity */
    bicycle_scalar_population_real mean_square;      /* [(rad/s)^2] mean square of the error */
    bicycle_scalar_population_real excitation;       /* [(rad/s)^2] mean square of the sensitivity */
    bicycle_scalar_population_real slowness;         /* [1/(m/s)] 1/last U */
    bicycle_scalar_population_real last_input;       /* [rad] last usable input */
    bicycle_scalar_population_real last_measured;    /* [rad/s] last usable measurement */
    bicycle_scalar_population_real last_U;           /* [m/s] last forward speed fast enough to learn */
    bicycle_scalar_population_real fresh;            /* [-] usable samples in a row */
    bicycle_scalar_population_real started;          /* [-] 0 before the first usable scale, 1 after */
} bicycle_scalar_population_state;

typedef struct bicycle_scalar_population_sample {
    bicycle_scalar_population_real dt;               /* [s] time since the sample before */
    bicycle_scalar_population_real input;            /* [rad] road-wheel steer angle */
    bicycle_scalar_population_real U;                /* [m/s] forward speed */
    bicycle_scalar_population_real measured;         /* [rad/s] measured yaw rate */
} bicycle_scalar_population_sample;

typedef struct bicycle_scalar_population_output {
    bicycle_scalar_population_real estimate;         /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_scalar_population_real variance;         /* [-] variance of ln K */
    bicycle_scalar_population_real predicted;        /* [rad/s] yaw rate predicted before the measurement */
    bicycle_scalar_population_real innovation;       /* [rad/s] measured minus predicted; 0 without a measurement */
    bicycle_scalar_population_real innovation_variance; /* [(rad/s)^2] variance of the innovation */
} bicycle_scalar_population_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void bicycle_scalar_population_init(const bicycle_scalar_population_config *config, bicycle_scalar_population_state *state)
{
    state->K = config->K_start;
    state->p = config->start_variance;
    state->input_gain = (-R(1.0)/(config->rho*(config->pi1 - R(1.0))));
    state->damping = (-(config->eta + config->pi1 + config->rho + config->eta*config->pi1*config->rho - config->eta*config->pi1 - config->pi1*config->rho)/(config->rho*(config->pi1 - R(1.0))));
    state->stiffness = (-(config->eta - R(1.0))/(config->rho*(config->pi1 - R(1.0))));
    state->pair_output = config->eta/(config->rho*((config->pi1 - R(1.0))*(config->pi1 - R(1.0))));
    state->pair_input = config->eta/(config->rho*((config->pi1 - R(1.0))*(config->pi1 - R(1.0))));
    state->inv_interval = (R(1.0)/config->sample_time);
    state->y = R(0.0);
    state->w = R(0.0);
    state->y_slope = R(0.0);
    state->w_slope = R(0.0);
    state->error_offset = R(0.0);
    state->slope_offset = R(0.0);
    state->mean_square = R(0.0);
    state->excitation = R(0.0);
    state->slowness = (R(1.0)/config->U_least);
    state->last_input = R(0.0);
    state->last_measured = R(0.0);
    state->last_U = config->U_least;
    state->fresh = R(0.0);
    state->started = R(0.0);
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_scalar_population_advance(const bicycle_scalar_population_config *config, bicycle_scalar_population_state *state,
                                     const bicycle_scalar_population_sample *sample, bicycle_scalar_population_output *output)
{
    int edge = 0;
    bicycle_scalar_population_real estimate = R(0.0);
    bicycle_scalar_population_real excited = R(0.0);
    bicycle_scalar_population_real innovation = R(0.0);
    bicycle_scalar_population_real innovation_variance = R(0.0);
    int live = 0;
    bicycle_scalar_population_real predicted = R(0.0);
    bicycle_scalar_population_real scale_now = R(0.0);
    int status = 0;
    bicycle_scalar_population_real u_now = R(0.0);
    bicycle_scalar_population_real usable = R(0.0);
    bicycle_scalar_population_real variance = R(0.0);
    bicycle_scalar_population_real y_now = R(0.0);

    predicted = state->last_measured;
    innovation = R(0.0);
    if ((sample->dt < R(1000000.0)) && (sample->dt > R(0.0))) { /* time must advance */
        status = 1;
        usable = R(1.0);
        if ((sample->U < config->signal_limit) && (sample->U > (-config->signal_limit)) && (sample->input < config->input_limit) && (sample->input > (-config->input_limit))) { /* a missing input or scale is held */
            u_now = sample->input;
            scale_now = sample->U;
        } else {
            u_now = state->last_input;
            scale_now = state->last_U;
            usable = R(0.0);
        }
        if ((!((((sample->measured - state->last_measured) < (-config->output_jump)) || ((sample->measured - state->last_measured) > config->output_jump)) && (state->fresh > R(0.5)))) && (sample->measured < config->output_limit) && (sample->measured > (-config->output_limit))) { /* so is an output */
            y_now = sample->measured;
        } else {
            y_now = state->last_measured;
            usable = R(0.0);
        }
        if (scale_now > config->U_least) { /* fast enough to see the dynamics */
            if ((scale_now < state->last_U) || (scale_now > state->last_U)) { /* another scale */
                state->last_U = scale_now;
                state->slowness = (R(1.0)/state->last_U);
            }
            live = 1;
            state->started = R(1.0);
        } else {
            live = 0;
            status = 6;
        }
        if ((!((sample->dt < config->dt_high) && (sample->dt > config->dt_low))) && (state->fresh > R(0.5))) { /* the sample before is elsewhere */
            state->fresh = R(0.0);
            status = 5;
        }
        if (usable > R(0.5)) { /* usable samples in a row */
            state->fresh = R(1.0) + ((state->fresh) < (config->settle_samples) ? state->fresh : config->settle_samples);
        } else {
            state->fresh = R(0.0);
            status = 4;
        }
        const bicycle_scalar_population_real u = R(0.5)*state->last_input + R(0.5)*u_now; /* mean of the sample's two ends */
        const bicycle_scalar_population_real a = state->K*state->damping*state->slowness/config->L;
        const bicycle_scalar_population_real b_1 = state->K*state->stiffness/((config->L*config->L));
        const bicycle_scalar_population_real b_2 = state->pair_output*(state->K*state->K)*(state->slowness*state->slowness)/((config->L*config->L));
        const bicycle_scalar_population_real b = b_1 + b_2;
        const bicycle_scalar_population_real b_slope = b_1 + R(2.0)*b_2;
        const bicycle_scalar_population_real c = state->K*state->input_gain/((config->L*config->L));
        const bicycle_scalar_population_real d = state->pair_input*state->slowness*(state->K*state->K)/((config->L*config->L*config->L));
        if ((live > 0) && (sample->dt < config->dt_high) && (sample->dt > config->dt_low)) { /* the step is one sample long */
            const bicycle_scalar_population_real q = R(0.5)*sample->dt;
            const bicycle_scalar_population_real qa = a*q;
            const bicycle_scalar_population_real inv_det = (R(1.0)/(R(1.0) + qa + b*(q*q)));
            const bicycle_scalar_population_real y_forced = state->w + R(2.0)*d*q*u - b*q*state->y;
            const bicycle_scalar_population_real y_after = inv_det*(q*(state->w + y_forced + R(2.0)*c*u) + state->y*(R(1.0) - qa));
            const bicycle_scalar_population_real y_middle = R(0.5)*state->y + R(0.5)*y_after;
            state->w = y_forced - b*q*y_after;
            const bicycle_scalar_population_real y_slope_forced = state->w_slope + R(2.0)*q*(R(2.0)*d*u - b_slope*y_middle) - b*q*state->y_slope;
            const bicycle_scalar_population_real y_slope_after = inv_det*(q*(state->w_slope + y_slope_forced + R(2.0)*c*u - R(2.0)*a*y_middle) + state->y_slope*(R(1.0) - qa));
            state->w_slope = y_slope_forced - b*q*y_slope_after;
            state->y = y_after;
            state->y_slope = y_slope_after;
            const bicycle_scalar_population_real error = y_now - state->y;
            const bicycle_scalar_population_real follow = usable*((R(1.0)) < (sample->dt*config->offset_rate) ? R(1.0) : sample->dt*config->offset_rate);
            state->error_offset = state->error_offset + follow*(error - state->error_offset);
            state->slope_offset = state->slope_offset + follow*(state->y_slope - state->slope_offset);
            const bicycle_scalar_population_real psi = state->y_slope - state->slope_offset; /* sensitivity without its slow part */
            const bicycle_scalar_population_real residual = error - state->error_offset; /* error without its slow part */
            predicted = y_now - residual;
            if (usable > R(0.5)) {
                innovation = residual;
                state->mean_square = state->mean_square + ((residual*residual) - state->mean_square)*((R(1.0)) < (sample->dt*config->scatter_rate) ? R(1.0) : sample->dt*config->scatter_rate);
                const bicycle_scalar_population_real drive = psi; /* what the input alone does to the regression */
                state->excitation = state->excitation + ((drive*drive) - state->excitation)*((R(1.0)) < (sample->dt*config->excitation_rate) ? R(1.0) : sample->dt*config->excitation_rate);
                excited = (state->excitation > config->excitation_least ? R(1.0) : R(0.0));
                if ((excited > R(0.5)) && (state->fresh > config->settle_samples)) { /* the input says something of the unknown */
                    const bicycle_scalar_population_real weighed = config->noise_variance + R(2.0)*state->inv_interval*config->structure_time*((R(0.0)) > (state->mean_square - config->noise_variance) ? R(0.0) : state->mean_square - config->noise_variance);
                    const bicycle_scalar_population_real gain = state->p*psi/((weighed + state->p*(psi*psi)));
                    const bicycle_scalar_population_real wanted = gain*residual;
                    const bicycle_scalar_population_real move = (((-config->move_limit)) > (((config->move_limit) < (wanted) ? config->move_limit : wanted)) ? (-config->move_limit) : ((config->move_limit) < (wanted) ? config->move_limit : wanted));
                    state->p = state->p - gain*state->p*psi;
                    state->K = state->K*(R(1.0) + move*(R(1.0) + move*(R(0.5) + R(0.16666666666666666)*move)));
                    edge = 0;
                    if ((state->K < config->K_low) || (state->K > config->K_high)) { /* no car is softer or stiffer */
                        state->K = ((state->K) > (config->K_low) ? state->K : config->K_low);
                        state->K = ((state->K) < (config->K_high) ? state->K : config->K_high);
                        edge = 1;
                    }
                    status = 0;
                    if ((state->last_U*state->last_U)*(y_now*y_now) > (config->validity_limit*config->validity_limit)) {
                        status = 2;
                    }
                    if (edge > 0) { /* the population's edge */
                        status = 3;
                    }
                }
            }
            state->p = ((config->start_variance) < (state->p + config->drift*sample->dt) ? config->start_variance : state->p + config->drift*sample->dt); /* unseen, K may change */
            const bicycle_scalar_population_real pull = usable*((R(1.0)) < (sample->dt*config->observer_rate) ? R(1.0) : sample->dt*config->observer_rate);
            state->y = state->y + pull*residual;
            state->y_slope = state->y_slope - psi*pull;
        } else {
            state->y = y_now;
            state->w = a*y_now - c*u;
            state->y_slope = R(0.0);
            state->w_slope = R(0.0);
            state->error_offset = R(0.0);
            state->slope_offset = R(0.0);
        }
        state->last_input = u_now;
        state->last_measured = y_now;
    } else {
        status = 7;
    }
    estimate = state->K;
    innovation_variance = ((state->mean_square) > (config->noise_variance) ? state->mean_square : config->noise_variance);
    variance = ((config->variance_limit) < (config->frozen_variance + state->p) ? config->variance_limit : config->frozen_variance + state->p);

    output->estimate = estimate;
    output->variance = variance;
    output->predicted = predicted;
    output->innovation = innovation;
    output->innovation_variance = innovation_variance;
    return status;
}

/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int bicycle_scalar_population_step(const bicycle_scalar_population_config *config, bicycle_scalar_population_state *state,
                               const bicycle_scalar_population_sample *sample, bicycle_scalar_population_output *output)
{
    return bicycle_scalar_population_advance(config, state, sample, output);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long bicycle_scalar_population_batch(const bicycle_scalar_population_config *config, bicycle_scalar_population_state *state, long n,
                                 const bicycle_scalar_population_sample *samples, bicycle_scalar_population_output *outputs, int *status)
{
    bicycle_scalar_population_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = bicycle_scalar_population_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}
