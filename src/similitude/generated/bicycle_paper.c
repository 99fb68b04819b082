/* Regression of the paper for the bicycle. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle, Brennan & Alleyne 2004, eqs 1-4
 *   base: m, L, U
 *   unknown: pi3; in proportion to it: pi4
 *   m1/T = pi1/pi5
 *   m2/T = (pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1))/pi5
 *
 * Operations: step 162 at most, 14 at least (arithmetic, comparisons, selects), init 27.
 * Memory: state 31 reals, configuration 34 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL bicycle_paper_real;
#define R(x) ((bicycle_paper_real)(x))

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
    bicycle_paper_real biquad_1[5];                  /* [-] first section: b0, b1, b2, a1, a2 of the high-pass */
    bicycle_paper_real biquad_2[5];                  /* [-] second section: b0, b1, b2, a1, a2 of the high-pass */
    bicycle_paper_real pi3_start;                    /* [-] pi3 before the first update */
    bicycle_paper_real P_start;                      /* [-] P before the first update */
    bicycle_paper_real forgetting;                   /* [-] share of the past kept at each update */
    bicycle_paper_real dead_zone;                    /* [rad/s] |r| that must be exceeded for an update */
    bicycle_paper_real settle_samples;               /* [-] whole samples in a row before an update, 3 or more */
    bicycle_paper_real noise_variance;               /* [(rad/s)^2] least variance of r a sample, > 0 */
    bicycle_paper_real pi3_low;                      /* [-] least pi3 that is reported, > 0 */
    bicycle_paper_real pi3_limit;                    /* [-] greatest magnitude of pi3 */
    bicycle_paper_real P_low;                        /* [-] least P, > 0 */
    bicycle_paper_real P_high;                       /* [-] greatest P */
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
    bicycle_paper_real m1_rate;                      /* [-] m1/T */
    bicycle_paper_real m2_rate;                      /* [-] m2/T */
    bicycle_paper_real m1;                           /* [1/(rad)] m1 per physical input at the last usable scale */
    bicycle_paper_real m2;                           /* [1/(rad/s)] m2 per physical output, the same */
    bicycle_paper_real unit;                         /* [rad/s] output per dimensionless output, the same */
    bicycle_paper_real star;                         /* [1/(rad/s)] its reciprocal */
    bicycle_paper_real inv_direct;                   /* [-] 1/weight of the newest output in the filter */
    bicycle_paper_real inv_forgetting;               /* [-] 1/forgetting factor */
    bicycle_paper_real least_spread;                 /* [(rad/s)^2] least variance of the filtered second difference */
    bicycle_paper_real theta;                        /* [-] pi3 at the last usable scale */
    bicycle_paper_real P;                            /* [-] covariance of theta per residual variance */
    bicycle_paper_real mean_square;                  /* [-] mean square of the residual */
    bicycle_paper_real weight;                       /* [-] updates the mean square rests on */
    bicycle_paper_real information;                  /* [-] information gained about ln K */
    bicycle_paper_real input_memory[4];              /* [rad] memory of both sections for delta */
    bicycle_paper_real output_memory[4];             /* [rad/s] memory of both sections for r */
    bicycle_paper_real input_before[2];              /* [rad] filtered delta, one and two samples ago */
    bicycle_paper_real output_before[2];             /* [rad/s] filtered r, one and two samples ago */
    bicycle_paper_real last_input;                   /* [rad] last usable input */
    bicycle_paper_real last_measured;                /* [rad/s] last usable measurement */
    bicycle_paper_real last_U;                       /* [m/s] last forward speed fast enough to learn */
    bicycle_paper_real fresh;                        /* [-] usable samples in a row */
    bicycle_paper_real started;                      /* [-] 0 before the first usable scale, 1 after */
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
    const bicycle_paper_real L = config->L;
    const bicycle_paper_real pi1 = config->pi1;
    const bicycle_paper_real pi4_slope = config->pi4_slope;
    const bicycle_paper_real pi5 = config->pi5;
    const bicycle_paper_real sample_time = config->sample_time;
    const bicycle_paper_real biquad_1_0 = config->biquad_1[0];
    const bicycle_paper_real biquad_2_0 = config->biquad_2[0];
    const bicycle_paper_real pi3_start = config->pi3_start;
    const bicycle_paper_real P_start = config->P_start;
    const bicycle_paper_real forgetting = config->forgetting;
    const bicycle_paper_real noise_variance = config->noise_variance;
    const bicycle_paper_real U_least = config->U_least;
    bicycle_paper_real *const input_memory = state->input_memory;
    bicycle_paper_real *const output_memory = state->output_memory;
    bicycle_paper_real *const input_before = state->input_before;
    bicycle_paper_real *const output_before = state->output_before;
    bicycle_paper_real P;
    bicycle_paper_real fresh;
    bicycle_paper_real information;
    bicycle_paper_real inv_direct;
    bicycle_paper_real inv_forgetting;
    bicycle_paper_real last_U;
    bicycle_paper_real last_input;
    bicycle_paper_real last_measured;
    bicycle_paper_real least_spread;
    bicycle_paper_real m1;
    bicycle_paper_real m1_rate;
    bicycle_paper_real m2;
    bicycle_paper_real m2_rate;
    bicycle_paper_real mean_square;
    bicycle_paper_real star;
    bicycle_paper_real started;
    bicycle_paper_real theta;
    bicycle_paper_real unit;
    bicycle_paper_real weight;
    m1_rate = pi1/pi5;
    m2_rate = ((pi1*pi1) + pi4_slope*((pi1 - R(1.0))*(pi1 - R(1.0))) + pi5*(R(1.0) + pi4_slope))/pi5;
    inv_direct = R(1.0)/(biquad_1_0*biquad_2_0);
    inv_forgetting = (R(1.0)/forgetting);
    least_spread = noise_variance*(biquad_1_0*biquad_1_0)*(biquad_2_0*biquad_2_0);
    theta = pi3_start;
    P = P_start;
    mean_square = R(0.0);
    weight = R(0.0);
    information = R(0.0);
    input_memory[0] = R(0.0);
    input_memory[1] = R(0.0);
    input_memory[2] = R(0.0);
    input_memory[3] = R(0.0);
    output_memory[0] = R(0.0);
    output_memory[1] = R(0.0);
    output_memory[2] = R(0.0);
    output_memory[3] = R(0.0);
    input_before[0] = R(0.0);
    input_before[1] = R(0.0);
    output_before[0] = R(0.0);
    output_before[1] = R(0.0);
    last_input = R(0.0);
    last_measured = R(0.0);
    last_U = U_least;
    fresh = R(0.0);
    started = R(0.0);
    unit = last_U/L;
    star = L/last_U;
    m1 = last_U*m1_rate*sample_time/L; /* eq 22, per physical input */
    m2 = last_U*m2_rate*sample_time*star/L; /* eq 22, per physical output */
    state->m1_rate = m1_rate;
    state->m2_rate = m2_rate;
    state->m1 = m1;
    state->m2 = m2;
    state->unit = unit;
    state->star = star;
    state->inv_direct = inv_direct;
    state->inv_forgetting = inv_forgetting;
    state->least_spread = least_spread;
    state->theta = theta;
    state->P = P;
    state->mean_square = mean_square;
    state->weight = weight;
    state->information = information;
    state->last_input = last_input;
    state->last_measured = last_measured;
    state->last_U = last_U;
    state->fresh = fresh;
    state->started = started;
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_paper_advance(const bicycle_paper_config *config, bicycle_paper_state *state,
                                     const bicycle_paper_sample *sample, bicycle_paper_output *output)
{
    const bicycle_paper_real L = config->L;
    const bicycle_paper_real sample_time = config->sample_time;
    const bicycle_paper_real biquad_1_0 = config->biquad_1[0];
    const bicycle_paper_real biquad_1_1 = config->biquad_1[1];
    const bicycle_paper_real biquad_1_2 = config->biquad_1[2];
    const bicycle_paper_real biquad_1_3 = config->biquad_1[3];
    const bicycle_paper_real biquad_1_4 = config->biquad_1[4];
    const bicycle_paper_real biquad_2_0 = config->biquad_2[0];
    const bicycle_paper_real biquad_2_1 = config->biquad_2[1];
    const bicycle_paper_real biquad_2_2 = config->biquad_2[2];
    const bicycle_paper_real biquad_2_3 = config->biquad_2[3];
    const bicycle_paper_real biquad_2_4 = config->biquad_2[4];
    const bicycle_paper_real forgetting = config->forgetting;
    const bicycle_paper_real dead_zone = config->dead_zone;
    const bicycle_paper_real settle_samples = config->settle_samples;
    const bicycle_paper_real noise_variance = config->noise_variance;
    const bicycle_paper_real pi3_low = config->pi3_low;
    const bicycle_paper_real pi3_limit = config->pi3_limit;
    const bicycle_paper_real P_low = config->P_low;
    const bicycle_paper_real P_high = config->P_high;
    const bicycle_paper_real variance_limit = config->variance_limit;
    const bicycle_paper_real dt_low = config->dt_low;
    const bicycle_paper_real dt_high = config->dt_high;
    const bicycle_paper_real U_least = config->U_least;
    const bicycle_paper_real input_limit = config->input_limit;
    const bicycle_paper_real output_limit = config->output_limit;
    const bicycle_paper_real output_jump = config->output_jump;
    const bicycle_paper_real signal_limit = config->signal_limit;
    const bicycle_paper_real validity_limit = config->validity_limit;
    const bicycle_paper_real dt = sample->dt;
    const bicycle_paper_real input = sample->input;
    const bicycle_paper_real U = sample->U;
    const bicycle_paper_real measured = sample->measured;
    bicycle_paper_real *const input_memory = state->input_memory;
    bicycle_paper_real *const output_memory = state->output_memory;
    bicycle_paper_real *const input_before = state->input_before;
    bicycle_paper_real *const output_before = state->output_before;
    bicycle_paper_real m1_rate = state->m1_rate;
    bicycle_paper_real m2_rate = state->m2_rate;
    bicycle_paper_real m1 = state->m1;
    bicycle_paper_real m2 = state->m2;
    bicycle_paper_real unit = state->unit;
    bicycle_paper_real star = state->star;
    bicycle_paper_real inv_direct = state->inv_direct;
    bicycle_paper_real inv_forgetting = state->inv_forgetting;
    bicycle_paper_real least_spread = state->least_spread;
    bicycle_paper_real theta = state->theta;
    bicycle_paper_real P = state->P;
    bicycle_paper_real mean_square = state->mean_square;
    bicycle_paper_real weight = state->weight;
    bicycle_paper_real information = state->information;
    bicycle_paper_real last_input = state->last_input;
    bicycle_paper_real last_measured = state->last_measured;
    bicycle_paper_real last_U = state->last_U;
    bicycle_paper_real fresh = state->fresh;
    bicycle_paper_real started = state->started;
    bicycle_paper_real estimate = R(0.0);
    bicycle_paper_real information_gained = R(0.0);
    bicycle_paper_real innovation = R(0.0);
    bicycle_paper_real innovation_variance = R(0.0);
    bicycle_paper_real live = R(0.0);
    bicycle_paper_real pi3 = R(0.0);
    bicycle_paper_real predicted = R(0.0);
    bicycle_paper_real scale_now = R(0.0);
    bicycle_paper_real status = R(0.0);
    bicycle_paper_real u_now = R(0.0);
    bicycle_paper_real usable = R(0.0);
    bicycle_paper_real variance = R(0.0);
    bicycle_paper_real y_now = R(0.0);

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
                if (started > R(0.5)) { /* the same constant */
                    const bicycle_paper_real ratio = (last_U*last_U)/((scale_now*scale_now)); /* of pi3 for the same K */
                    theta = ratio*theta;
                    P = P*(ratio*ratio);
                }
                last_U = scale_now;
                unit = last_U/L;
                star = L/last_U;
                m1 = last_U*m1_rate*sample_time/L; /* eq 22, per physical input */
                m2 = last_U*m2_rate*sample_time*star/L; /* eq 22, per physical output */
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
        const bicycle_paper_real phi = m1*(input_before[0] - input_before[1]) + m2*(output_before[1] - output_before[0]); /* regressor, eqs 25-26 */
        const bicycle_paper_real filtered = R(2.0)*output_before[0] + phi*theta*unit - output_before[1]; /* filtered output predicted */
        const bicycle_paper_real rest = output_memory[2] + biquad_2_0*output_memory[0]; /* filtered output if the newest were zero */
        predicted = inv_direct*(filtered - rest);
        if (usable > R(0.5)) {
            innovation = y_now - predicted;
        }
        const bicycle_paper_real input_half = input_memory[0] + biquad_1_0*u_now;
        input_memory[0] = input_memory[1] + biquad_1_1*u_now - biquad_1_3*input_half;
        input_memory[1] = biquad_1_2*u_now - biquad_1_4*input_half;
        const bicycle_paper_real input_filtered = input_memory[2] + biquad_2_0*input_half;
        input_memory[2] = input_memory[3] + biquad_2_1*input_half - biquad_2_3*input_filtered;
        input_memory[3] = biquad_2_2*input_half - biquad_2_4*input_filtered;
        const bicycle_paper_real output_half = output_memory[0] + biquad_1_0*y_now;
        output_memory[0] = output_memory[1] + biquad_1_1*y_now - biquad_1_3*output_half;
        output_memory[1] = biquad_1_2*y_now - biquad_1_4*output_half;
        const bicycle_paper_real output_filtered = output_memory[2] + biquad_2_0*output_half;
        output_memory[2] = output_memory[3] + biquad_2_1*output_half - biquad_2_3*output_filtered;
        output_memory[3] = biquad_2_2*output_half - biquad_2_4*output_filtered;
        const bicycle_paper_real y = star*(output_before[1] + output_filtered - R(2.0)*output_before[0]); /* second difference, eq 24 */
        if (((y_now < (-dead_zone)) || (y_now > dead_zone)) && (fresh > settle_samples) && (live > R(0.5))) { /* outside the dead zone, filters settled */
            const bicycle_paper_real residual = y - phi*theta;
            const bicycle_paper_real gain = P*phi/((forgetting + P*(phi*phi)));
            weight = R(1.0) + forgetting*weight;
            mean_square = mean_square + ((residual*residual) - mean_square)/weight;
            const bicycle_paper_real spread = ((mean_square) > (least_spread*(star*star)) ? mean_square : least_spread*(star*star)); /* never below the sensor's share */
            information = information + (phi*phi)*(theta*theta)/spread;
            theta = theta + gain*residual;
            theta = ((pi3_limit) < (theta) ? pi3_limit : theta);
            theta = (((-pi3_limit)) > (theta) ? (-pi3_limit) : theta);
            P = P*inv_forgetting*(R(1.0) - gain*phi);
            P = ((P) < (P_high) ? P : P_high);
            P = ((P) > (P_low) ? P : P_low);
            status = R(0.0);
            if ((last_U*last_U)*(y_now*y_now) > (validity_limit*validity_limit)) {
                status = R(2.0);
            }
            if (theta <= pi3_low) { /* no stiffness is zero or less */
                status = R(3.0);
            }
        }
        output_before[1] = output_before[0];
        output_before[0] = output_filtered;
        input_before[1] = input_before[0];
        input_before[0] = input_filtered;
        last_input = u_now;
        last_measured = y_now;
    } else {
        status = R(7.0);
    }
    pi3 = ((pi3_low) > (theta) ? pi3_low : theta);
    estimate = pi3*(last_U*last_U);
    const bicycle_paper_real raw = inv_direct*unit; /* raw output per dimensionless residual */
    innovation_variance = ((noise_variance) > (mean_square*(raw*raw)) ? noise_variance : mean_square*(raw*raw));
    variance = variance_limit;
    if (weight > R(0.5)) {
        const bicycle_paper_real scatter = P*innovation_variance/((pi3*pi3)*(raw*raw));
        variance = ((scatter) < (variance_limit) ? scatter : variance_limit);
    }
    information_gained = information;

    state->m1 = m1;
    state->m2 = m2;
    state->unit = unit;
    state->star = star;
    state->theta = theta;
    state->P = P;
    state->mean_square = mean_square;
    state->weight = weight;
    state->information = information;
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
    output->information_gained = information_gained;
    output->pi3 = pi3;
    return (int)status;
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
