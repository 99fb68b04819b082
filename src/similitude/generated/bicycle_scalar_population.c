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
    const bicycle_scalar_population_real pi1 = config->pi1;
    const bicycle_scalar_population_real eta = config->eta;
    const bicycle_scalar_population_real rho = config->rho;
    const bicycle_scalar_population_real sample_time = config->sample_time;
    const bicycle_scalar_population_real K_start = config->K_start;
    const bicycle_scalar_population_real start_variance = config->start_variance;
    const bicycle_scalar_population_real U_least = config->U_least;
    bicycle_scalar_population_real K;
    bicycle_scalar_population_real damping;
    bicycle_scalar_population_real error_offset;
    bicycle_scalar_population_real excitation;
    bicycle_scalar_population_real fresh;
    bicycle_scalar_population_real input_gain;
    bicycle_scalar_population_real inv_interval;
    bicycle_scalar_population_real last_U;
    bicycle_scalar_population_real last_input;
    bicycle_scalar_population_real last_measured;
    bicycle_scalar_population_real mean_square;
    bicycle_scalar_population_real p;
    bicycle_scalar_population_real pair_input;
    bicycle_scalar_population_real pair_output;
    bicycle_scalar_population_real slope_offset;
    bicycle_scalar_population_real slowness;
    bicycle_scalar_population_real started;
    bicycle_scalar_population_real stiffness;
    bicycle_scalar_population_real w;
    bicycle_scalar_population_real w_slope;
    bicycle_scalar_population_real y;
    bicycle_scalar_population_real y_slope;
    K = K_start;
    p = start_variance;
    input_gain = (-R(1.0)/(rho*(pi1 - R(1.0))));
    damping = (-(eta + pi1 + rho + eta*pi1*rho - eta*pi1 - pi1*rho)/(rho*(pi1 - R(1.0))));
    stiffness = (-(eta - R(1.0))/(rho*(pi1 - R(1.0))));
    pair_output = eta/(rho*((pi1 - R(1.0))*(pi1 - R(1.0))));
    pair_input = eta/(rho*((pi1 - R(1.0))*(pi1 - R(1.0))));
    inv_interval = (R(1.0)/sample_time);
    y = R(0.0);
    w = R(0.0);
    y_slope = R(0.0);
    w_slope = R(0.0);
    error_offset = R(0.0);
    slope_offset = R(0.0);
    mean_square = R(0.0);
    excitation = R(0.0);
    slowness = (R(1.0)/U_least);
    last_input = R(0.0);
    last_measured = R(0.0);
    last_U = U_least;
    fresh = R(0.0);
    started = R(0.0);
    state->K = K;
    state->p = p;
    state->input_gain = input_gain;
    state->damping = damping;
    state->stiffness = stiffness;
    state->pair_output = pair_output;
    state->pair_input = pair_input;
    state->inv_interval = inv_interval;
    state->y = y;
    state->w = w;
    state->y_slope = y_slope;
    state->w_slope = w_slope;
    state->error_offset = error_offset;
    state->slope_offset = slope_offset;
    state->mean_square = mean_square;
    state->excitation = excitation;
    state->slowness = slowness;
    state->last_input = last_input;
    state->last_measured = last_measured;
    state->last_U = last_U;
    state->fresh = fresh;
    state->started = started;
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_scalar_population_advance(const bicycle_scalar_population_config *config, bicycle_scalar_population_state *state,
                                     const bicycle_scalar_population_sample *sample, bicycle_scalar_population_output *output)
{
    const bicycle_scalar_population_real L = config->L;
    const bicycle_scalar_population_real K_low = config->K_low;
    const bicycle_scalar_population_real K_high = config->K_high;
    const bicycle_scalar_population_real start_variance = config->start_variance;
    const bicycle_scalar_population_real frozen_variance = config->frozen_variance;
    const bicycle_scalar_population_real noise_variance = config->noise_variance;
    const bicycle_scalar_population_real drift = config->drift;
    const bicycle_scalar_population_real structure_time = config->structure_time;
    const bicycle_scalar_population_real scatter_rate = config->scatter_rate;
    const bicycle_scalar_population_real offset_rate = config->offset_rate;
    const bicycle_scalar_population_real observer_rate = config->observer_rate;
    const bicycle_scalar_population_real move_limit = config->move_limit;
    const bicycle_scalar_population_real excitation_least = config->excitation_least;
    const bicycle_scalar_population_real excitation_rate = config->excitation_rate;
    const bicycle_scalar_population_real variance_limit = config->variance_limit;
    const bicycle_scalar_population_real settle_samples = config->settle_samples;
    const bicycle_scalar_population_real dt_low = config->dt_low;
    const bicycle_scalar_population_real dt_high = config->dt_high;
    const bicycle_scalar_population_real U_least = config->U_least;
    const bicycle_scalar_population_real input_limit = config->input_limit;
    const bicycle_scalar_population_real output_limit = config->output_limit;
    const bicycle_scalar_population_real output_jump = config->output_jump;
    const bicycle_scalar_population_real signal_limit = config->signal_limit;
    const bicycle_scalar_population_real validity_limit = config->validity_limit;
    const bicycle_scalar_population_real dt = sample->dt;
    const bicycle_scalar_population_real input = sample->input;
    const bicycle_scalar_population_real U = sample->U;
    const bicycle_scalar_population_real measured = sample->measured;
    bicycle_scalar_population_real K = state->K;
    bicycle_scalar_population_real p = state->p;
    bicycle_scalar_population_real input_gain = state->input_gain;
    bicycle_scalar_population_real damping = state->damping;
    bicycle_scalar_population_real stiffness = state->stiffness;
    bicycle_scalar_population_real pair_output = state->pair_output;
    bicycle_scalar_population_real pair_input = state->pair_input;
    bicycle_scalar_population_real inv_interval = state->inv_interval;
    bicycle_scalar_population_real y = state->y;
    bicycle_scalar_population_real w = state->w;
    bicycle_scalar_population_real y_slope = state->y_slope;
    bicycle_scalar_population_real w_slope = state->w_slope;
    bicycle_scalar_population_real error_offset = state->error_offset;
    bicycle_scalar_population_real slope_offset = state->slope_offset;
    bicycle_scalar_population_real mean_square = state->mean_square;
    bicycle_scalar_population_real excitation = state->excitation;
    bicycle_scalar_population_real slowness = state->slowness;
    bicycle_scalar_population_real last_input = state->last_input;
    bicycle_scalar_population_real last_measured = state->last_measured;
    bicycle_scalar_population_real last_U = state->last_U;
    bicycle_scalar_population_real fresh = state->fresh;
    bicycle_scalar_population_real started = state->started;
    bicycle_scalar_population_real edge = R(0.0);
    bicycle_scalar_population_real estimate = R(0.0);
    bicycle_scalar_population_real excited = R(0.0);
    bicycle_scalar_population_real innovation = R(0.0);
    bicycle_scalar_population_real innovation_variance = R(0.0);
    bicycle_scalar_population_real live = R(0.0);
    bicycle_scalar_population_real predicted = R(0.0);
    bicycle_scalar_population_real scale_now = R(0.0);
    bicycle_scalar_population_real status = R(0.0);
    bicycle_scalar_population_real u_now = R(0.0);
    bicycle_scalar_population_real usable = R(0.0);
    bicycle_scalar_population_real variance = R(0.0);
    bicycle_scalar_population_real y_now = R(0.0);

    predicted = last_measured;
    innovation = R(0.0);
    if ((dt < R(1000000.0)) && (dt > R(0.0))) { /* time must advance */
        status = R(1.0);
        usable = R(1.0);
        if ((U < signal_limit) && (U > (-signal_limit)) && (input < input_limit) && (input > (-input_limit))) { /* a missing input or scale is held */
            u_now = input;
            scale_now = U;
        } else {
            u_now = last_input;
            scale_now = last_U;
            usable = R(0.0);
        }
        if ((!((((measured - last_measured) < (-output_jump)) || ((measured - last_measured) > output_jump)) && (fresh > R(0.5)))) && (measured < output_limit) && (measured > (-output_limit))) { /* so is an output */
            y_now = measured;
        } else {
            y_now = last_measured;
            usable = R(0.0);
        }
        if (scale_now > U_least) { /* fast enough to see the dynamics */
            if ((scale_now < last_U) || (scale_now > last_U)) { /* another scale */
                last_U = scale_now;
                slowness = (R(1.0)/last_U);
            }
            live = R(1.0);
            started = R(1.0);
        } else {
            live = R(0.0);
            status = R(6.0);
        }
        if ((!((dt < dt_high) && (dt > dt_low))) && (fresh > R(0.5))) { /* the sample before is elsewhere */
            fresh = R(0.0);
            status = R(5.0);
        }
        if (usable > R(0.5)) { /* usable samples in a row */
            fresh = R(1.0) + ((fresh) < (settle_samples) ? fresh : settle_samples);
        } else {
            fresh = R(0.0);
            status = R(4.0);
        }
        const bicycle_scalar_population_real u = R(0.5)*last_input + R(0.5)*u_now; /* mean of the sample's two ends */
        const bicycle_scalar_population_real a = K*damping*slowness/L;
        const bicycle_scalar_population_real b_1 = K*stiffness/((L*L));
        const bicycle_scalar_population_real b_2 = pair_output*(K*K)*(slowness*slowness)/((L*L));
        const bicycle_scalar_population_real b = b_1 + b_2;
        const bicycle_scalar_population_real b_slope = b_1 + R(2.0)*b_2;
        const bicycle_scalar_population_real c = K*input_gain/((L*L));
        const bicycle_scalar_population_real d = pair_input*slowness*(K*K)/((L*L*L));
        if ((dt < dt_high) && (dt > dt_low) && (live > R(0.5))) { /* the step is one sample long */
            const bicycle_scalar_population_real q = R(0.5)*dt;
            const bicycle_scalar_population_real qa = a*q;
            const bicycle_scalar_population_real inv_det = (R(1.0)/(R(1.0) + qa + b*(q*q)));
            const bicycle_scalar_population_real y_forced = w + R(2.0)*d*q*u - b*q*y;
            const bicycle_scalar_population_real y_after = inv_det*(q*(w + y_forced + R(2.0)*c*u) + y*(R(1.0) - qa));
            const bicycle_scalar_population_real y_middle = R(0.5)*y + R(0.5)*y_after;
            w = y_forced - b*q*y_after;
            const bicycle_scalar_population_real y_slope_forced = w_slope + R(2.0)*q*(R(2.0)*d*u - b_slope*y_middle) - b*q*y_slope;
            const bicycle_scalar_population_real y_slope_after = inv_det*(q*(w_slope + y_slope_forced + R(2.0)*c*u - R(2.0)*a*y_middle) + y_slope*(R(1.0) - qa));
            w_slope = y_slope_forced - b*q*y_slope_after;
            y = y_after;
            y_slope = y_slope_after;
            const bicycle_scalar_population_real error = y_now - y;
            const bicycle_scalar_population_real follow = usable*((R(1.0)) < (dt*offset_rate) ? R(1.0) : dt*offset_rate);
            error_offset = error_offset + follow*(error - error_offset);
            slope_offset = slope_offset + follow*(y_slope - slope_offset);
            const bicycle_scalar_population_real psi = y_slope - slope_offset; /* sensitivity without its slow part */
            const bicycle_scalar_population_real residual = error - error_offset; /* error without its slow part */
            predicted = y_now - residual;
            if (usable > R(0.5)) {
                innovation = residual;
                mean_square = mean_square + ((residual*residual) - mean_square)*((R(1.0)) < (dt*scatter_rate) ? R(1.0) : dt*scatter_rate);
                const bicycle_scalar_population_real drive = psi; /* what the input alone does to the regression */
                excitation = excitation + ((drive*drive) - excitation)*((R(1.0)) < (dt*excitation_rate) ? R(1.0) : dt*excitation_rate);
                excited = (excitation > excitation_least ? R(1.0) : R(0.0));
                if ((excited > R(0.5)) && (fresh > settle_samples)) { /* the input says something of the unknown */
                    const bicycle_scalar_population_real weighed = noise_variance + R(2.0)*inv_interval*structure_time*((R(0.0)) > (mean_square - noise_variance) ? R(0.0) : mean_square - noise_variance);
                    const bicycle_scalar_population_real gain = p*psi/((weighed + p*(psi*psi)));
                    const bicycle_scalar_population_real wanted = gain*residual;
                    const bicycle_scalar_population_real move = (((-move_limit)) > (((move_limit) < (wanted) ? move_limit : wanted)) ? (-move_limit) : ((move_limit) < (wanted) ? move_limit : wanted));
                    p = p - gain*p*psi;
                    K = K*(R(1.0) + move*(R(1.0) + move*(R(0.5) + R(0.16666666666666666)*move)));
                    edge = R(0.0);
                    if ((K < K_low) || (K > K_high)) { /* no car is softer or stiffer */
                        K = ((K) > (K_low) ? K : K_low);
                        K = ((K) < (K_high) ? K : K_high);
                        edge = R(1.0);
                    }
                    status = R(0.0);
                    if ((last_U*last_U)*(y_now*y_now) > (validity_limit*validity_limit)) {
                        status = R(2.0);
                    }
                    if (edge > R(0.5)) { /* the population's edge */
                        status = R(3.0);
                    }
                }
            }
            p = ((start_variance) < (p + drift*dt) ? start_variance : p + drift*dt); /* unseen, K may change */
            const bicycle_scalar_population_real pull = usable*((R(1.0)) < (dt*observer_rate) ? R(1.0) : dt*observer_rate);
            y = y + pull*residual;
            y_slope = y_slope - psi*pull;
        } else {
            y = y_now;
            w = a*y_now - c*u;
            y_slope = R(0.0);
            w_slope = R(0.0);
            error_offset = R(0.0);
            slope_offset = R(0.0);
        }
        last_input = u_now;
        last_measured = y_now;
    } else {
        status = R(7.0);
    }
    estimate = K;
    innovation_variance = ((mean_square) > (noise_variance) ? mean_square : noise_variance);
    variance = ((variance_limit) < (frozen_variance + p) ? variance_limit : frozen_variance + p);

    state->K = K;
    state->p = p;
    state->y = y;
    state->w = w;
    state->y_slope = y_slope;
    state->w_slope = w_slope;
    state->error_offset = error_offset;
    state->slope_offset = slope_offset;
    state->mean_square = mean_square;
    state->excitation = excitation;
    state->slowness = slowness;
    state->last_input = last_input;
    state->last_measured = last_measured;
    state->last_U = last_U;
    state->fresh = fresh;
    state->started = started;
    output->estimate = estimate;
    output->variance = variance;
    output->predicted = predicted;
    output->innovation = innovation;
    output->innovation_variance = innovation_variance;
    return (int)status;
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
