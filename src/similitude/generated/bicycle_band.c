/* First-order regression in a band of the bicycle. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle, Brennan & Alleyne 2004, eqs 1-4
 *   base: m, L, U
 *   unknown: K; frozen: pi1, eta, rho
 *   B1 = -1/(rho*(pi1 - 1))
 *   M2 = -(eta*pi1*rho - eta*pi1 + eta - pi1*rho + pi1 + rho)/(rho*(pi1 - 1))
 *
 * Operations: step 227 at most, 8 at least (arithmetic, comparisons, selects), init 16.
 * Memory: state 39 reals, configuration 50 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL bicycle_band_real;
#define R(x) ((bicycle_band_real)(x))

enum bicycle_band_status {
    BICYCLE_BAND_OK = 0,
    BICYCLE_BAND_NOT_EXCITED = 1,
    BICYCLE_BAND_OUTSIDE_LINEAR = 2,
    BICYCLE_BAND_AT_LIMIT = 3,
    BICYCLE_BAND_NO_MEASUREMENT = 4,
    BICYCLE_BAND_RESTARTED = 5,
    BICYCLE_BAND_TOO_SLOW = 6,
    BICYCLE_BAND_BAD_SAMPLE = 7
};

typedef struct bicycle_band_config {
    bicycle_band_real L;                             /* [m] wheelbase */
    bicycle_band_real pi1;                           /* [-] frozen a/L, position of the centre of gravity */
    bicycle_band_real eta;                           /* [-] frozen rear over front cornering coefficient; > 1 understeers */
    bicycle_band_real rho;                           /* [-] frozen Iz/(m a b), yaw inertia ratio */
    bicycle_band_real sample_time;                   /* [s] sample time the filters are designed for */
    bicycle_band_real biquad_1[5];                   /* [-] section 1, high-pass: b0, b1, b2, a1, a2 */
    bicycle_band_real biquad_2[5];                   /* [-] section 2, high-pass: b0, b1, b2, a1, a2 */
    bicycle_band_real biquad_3[5];                   /* [-] section 3, low-pass: b0, b1, b2, a1, a2 */
    bicycle_band_real biquad_4[5];                   /* [-] section 4, low-pass: b0, b1, b2, a1, a2 */
    bicycle_band_real forgetting;                    /* [-] share of the past kept at each update */
    bicycle_band_real noise_variance;                /* [(rad/s)^2] variance of r a sample that is taken out */
    bicycle_band_real noise_zero;                    /* [-] autocorrelation of the band-pass at lag 0 */
    bicycle_band_real noise_one;                     /* [-] the same at lag 1 */
    bicycle_band_real signal_least;                  /* [-] least share of A that is signal */
    bicycle_band_real K_start;                       /* [m^2/s^2] K before the first update */
    bicycle_band_real K_low;                         /* [m^2/s^2] least K of the population */
    bicycle_band_real K_high;                        /* [m^2/s^2] greatest K of the population */
    bicycle_band_real excitation_least;              /* [-] least mean square of the drive to learn from, in its units */
    bicycle_band_real excitation_rate;               /* [1/s] averaging rate of that mean square */
    bicycle_band_real block;                         /* [s] length of a block of the scatter */
    bicycle_band_real block_keep;                    /* [-] share of the older blocks kept at each new one */
    bicycle_band_real blocks_most;                   /* [-] blocks remembered */
    bicycle_band_real scatter_low;                   /* [-] least variance of the residual, in its units, > 0 */
    bicycle_band_real variance_limit;                /* [-] greatest variance that is reported */
    bicycle_band_real idle_drift;                    /* [1/s] growth of the variance while nothing is learnt */
    bicycle_band_real settle_samples;                /* [-] whole samples in a row before an update, 3 or more */
    bicycle_band_real dt_low;                        /* [s] shortest step that counts as one sample */
    bicycle_band_real dt_high;                       /* [s] longest step that counts as one sample */
    bicycle_band_real U_least;                       /* [m/s] least forward speed to learn at, > 0 */
    bicycle_band_real input_limit;                   /* [rad] greatest believable delta */
    bicycle_band_real output_limit;                  /* [rad/s] greatest believable r */
    bicycle_band_real output_jump;                   /* [rad/s] greatest believable change of r in one sample */
    bicycle_band_real signal_limit;                  /* [m/s] greatest believable scale */
    bicycle_band_real validity_limit;                /* [m/s^2] edge of the model's linear range */
} bicycle_band_config;

typedef struct bicycle_band_state {
    bicycle_band_real K;                             /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_band_real input_gain;                    /* [s] B1 times the sample time */
    bicycle_band_real damping;                       /* [s] M2 times the sample time */
    bicycle_band_real Q;                             /* [(rad/s)^2] sum of regressor times change */
    bicycle_band_real A;                             /* [(rad/s)^2] sum of squared regressor */
    bicycle_band_real input_memory[8];               /* [rad] memory of the sections for delta */
    bicycle_band_real output_memory[8];              /* [rad/s] memory of the sections for r */
    bicycle_band_real input_before;                  /* [rad] filtered delta of the sample before */
    bicycle_band_real output_before;                 /* [rad/s] filtered r of the sample before */
    bicycle_band_real excitation;                    /* [-] mean square of the drive, in its units */
    bicycle_band_real mean_square;                   /* [-] mean square of the innovation, in its units */
    bicycle_band_real block_score;                   /* [-] sum of regressor times residual over this block */
    bicycle_band_real block_weight;                  /* [-] sum of squared regressor over this block */
    bicycle_band_real block_age;                     /* [s] age of this block */
    bicycle_band_real scatter_sum;                   /* [-] squared scores of the blocks remembered */
    bicycle_band_real scatter_weight;                /* [-] their weights */
    bicycle_band_real blocks;                        /* [-] how many there are */
    bicycle_band_real log_variance;                  /* [-] variance of ln K from the scatter */
    bicycle_band_real aged;                          /* [-] variance grown while nothing was learnt */
    bicycle_band_real information;                   /* [-] information gained about ln K */
    bicycle_band_real last_input;                    /* [rad] last usable input */
    bicycle_band_real last_measured;                 /* [rad/s] last usable measurement */
    bicycle_band_real last_U;                        /* [m/s] last forward speed fast enough to learn */
    bicycle_band_real fresh;                         /* [-] usable samples in a row */
    bicycle_band_real started;                       /* [-] 0 before the first usable scale, 1 after */
} bicycle_band_state;

typedef struct bicycle_band_sample {
    bicycle_band_real dt;                            /* [s] time since the sample before */
    bicycle_band_real input;                         /* [rad] road-wheel steer angle */
    bicycle_band_real U;                             /* [m/s] forward speed */
    bicycle_band_real measured;                      /* [rad/s] measured yaw rate */
} bicycle_band_sample;

typedef struct bicycle_band_output {
    bicycle_band_real estimate;                      /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_band_real variance;                      /* [-] variance of ln K */
    bicycle_band_real predicted;                     /* [rad/s] yaw rate predicted before the measurement */
    bicycle_band_real innovation;                    /* [rad/s] measured minus predicted; 0 without a measurement */
    bicycle_band_real innovation_variance;           /* [(rad/s)^2] variance of the innovation */
    bicycle_band_real information_gained;            /* [-] information gained about ln K so far */
    bicycle_band_real unknowns;                      /* [-] unknowns the excitation carries now; 0 while nothing is learnt */
} bicycle_band_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void bicycle_band_init(const bicycle_band_config *config, bicycle_band_state *state)
{
    bicycle_band_real *const input_memory = state->input_memory;
    bicycle_band_real *const output_memory = state->output_memory;
    int i;
    for (i = 0; i < 8; ++i) {
        input_memory[i] = R(0.0);
    }
    for (i = 0; i < 8; ++i) {
        output_memory[i] = R(0.0);
    }
    state->K = config->K_start;
    state->input_gain = (-config->sample_time/(config->rho*(config->pi1 - R(1.0))));
    state->damping = (-config->sample_time*(config->eta + config->pi1 + config->rho + config->eta*config->pi1*config->rho - config->eta*config->pi1 - config->pi1*config->rho)/(config->rho*(config->pi1 - R(1.0))));
    state->Q = R(0.0);
    state->A = R(0.0);
    state->input_before = R(0.0);
    state->output_before = R(0.0);
    state->excitation = R(0.0);
    state->mean_square = R(0.0);
    state->block_score = R(0.0);
    state->block_weight = R(0.0);
    state->block_age = R(0.0);
    state->scatter_sum = R(0.0);
    state->scatter_weight = R(0.0);
    state->blocks = (-R(1.0));
    state->log_variance = config->variance_limit;
    state->aged = R(0.0);
    state->information = R(0.0);
    state->last_input = R(0.0);
    state->last_measured = R(0.0);
    state->last_U = config->U_least;
    state->fresh = R(0.0);
    state->started = R(0.0);
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_band_advance(const bicycle_band_config *config, bicycle_band_state *state,
                                     const bicycle_band_sample *sample, bicycle_band_output *output)
{
    bicycle_band_real *const input_memory = state->input_memory;
    bicycle_band_real *const output_memory = state->output_memory;
    int edge = 0;
    bicycle_band_real estimate = R(0.0);
    bicycle_band_real excited = R(0.0);
    bicycle_band_real information_gained = R(0.0);
    bicycle_band_real innovation = R(0.0);
    bicycle_band_real innovation_variance = R(0.0);
    int live = 0;
    bicycle_band_real predicted = R(0.0);
    bicycle_band_real scale_now = R(0.0);
    bicycle_band_real spread = R(0.0);
    int status = 0;
    bicycle_band_real u_now = R(0.0);
    bicycle_band_real unknowns = R(0.0);
    int usable = 0;
    bicycle_band_real variance = R(0.0);
    bicycle_band_real y_now = R(0.0);

    predicted = state->last_measured;
    innovation = R(0.0);
    unknowns = R(0.0);
    if ((sample->dt < R(1000000.0)) && (sample->dt > R(0.0))) { /* time must advance */
        status = 1;
        usable = 1;
        if ((sample->U < config->signal_limit) && (sample->U > (-config->signal_limit)) && (sample->input < config->input_limit) && (sample->input > (-config->input_limit))) { /* a missing input or scale is held */
            u_now = sample->input;
            scale_now = sample->U;
        } else {
            u_now = state->last_input;
            scale_now = state->last_U;
            usable = 0;
        }
        if ((!((((sample->measured - state->last_measured) < (-config->output_jump)) || ((sample->measured - state->last_measured) > config->output_jump)) && (state->fresh > R(0.5)))) && (sample->measured < config->output_limit) && (sample->measured > (-config->output_limit))) { /* so is an output */
            y_now = sample->measured;
        } else {
            y_now = state->last_measured;
            usable = 0;
        }
        if (scale_now > config->U_least) { /* fast enough to see the dynamics */
            if ((scale_now < state->last_U) || (scale_now > state->last_U)) { /* another scale */
                state->last_U = scale_now;
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
        if (usable > 0) { /* usable samples in a row */
            state->fresh = R(1.0) + ((state->fresh) < (config->settle_samples) ? state->fresh : config->settle_samples);
        } else {
            state->fresh = R(0.0);
            status = 4;
        }
        const bicycle_band_real at_U = state->last_U;
        const bicycle_band_real inv_U = (R(1.0)/at_U);
        const bicycle_band_real inv_L = (R(1.0)/config->L);
        const bicycle_band_real input_after_1 = input_memory[0] + config->biquad_1[0]*u_now;
        input_memory[0] = input_memory[1] + config->biquad_1[1]*u_now - config->biquad_1[3]*input_after_1;
        input_memory[1] = config->biquad_1[2]*u_now - config->biquad_1[4]*input_after_1;
        const bicycle_band_real input_after_2 = input_memory[2] + config->biquad_2[0]*input_after_1;
        input_memory[2] = input_memory[3] + config->biquad_2[1]*input_after_1 - config->biquad_2[3]*input_after_2;
        input_memory[3] = config->biquad_2[2]*input_after_1 - config->biquad_2[4]*input_after_2;
        const bicycle_band_real input_after_3 = input_memory[4] + config->biquad_3[0]*input_after_2;
        input_memory[4] = input_memory[5] + config->biquad_3[1]*input_after_2 - config->biquad_3[3]*input_after_3;
        input_memory[5] = config->biquad_3[2]*input_after_2 - config->biquad_3[4]*input_after_3;
        const bicycle_band_real input_filtered = input_memory[6] + config->biquad_4[0]*input_after_3;
        input_memory[6] = input_memory[7] + config->biquad_4[1]*input_after_3 - config->biquad_4[3]*input_filtered;
        input_memory[7] = config->biquad_4[2]*input_after_3 - config->biquad_4[4]*input_filtered;
        const bicycle_band_real output_after_1 = output_memory[0] + config->biquad_1[0]*y_now;
        output_memory[0] = output_memory[1] + config->biquad_1[1]*y_now - config->biquad_1[3]*output_after_1;
        output_memory[1] = config->biquad_1[2]*y_now - config->biquad_1[4]*output_after_1;
        const bicycle_band_real output_after_2 = output_memory[2] + config->biquad_2[0]*output_after_1;
        output_memory[2] = output_memory[3] + config->biquad_2[1]*output_after_1 - config->biquad_2[3]*output_after_2;
        output_memory[3] = config->biquad_2[2]*output_after_1 - config->biquad_2[4]*output_after_2;
        const bicycle_band_real output_after_3 = output_memory[4] + config->biquad_3[0]*output_after_2;
        output_memory[4] = output_memory[5] + config->biquad_3[1]*output_after_2 - config->biquad_3[3]*output_after_3;
        output_memory[5] = config->biquad_3[2]*output_after_2 - config->biquad_3[4]*output_after_3;
        const bicycle_band_real output_filtered = output_memory[6] + config->biquad_4[0]*output_after_3;
        output_memory[6] = output_memory[7] + config->biquad_4[1]*output_after_3 - config->biquad_4[3]*output_filtered;
        output_memory[7] = config->biquad_4[2]*output_after_3 - config->biquad_4[4]*output_filtered;
        const bicycle_band_real from_input = state->input_gain*(inv_L*inv_L); /* psi per input */
        const bicycle_band_real from_output = state->damping*inv_L*inv_U; /* -psi per output */
        const bicycle_band_real driven = from_input*state->input_before;
        const bicycle_band_real psi = driven - from_output*state->output_before;
        const bicycle_band_real y = output_filtered - state->output_before;
        const bicycle_band_real residual = y - state->K*psi;
        innovation = (usable > 0 ? residual : R(0.0));
        predicted = y_now - innovation;
        const bicycle_band_real drive = state->K*driven; /* what the input alone does to the regression */
        state->excitation = state->excitation + ((drive*drive) - state->excitation)*((R(1.0)) < (sample->dt*config->excitation_rate) ? R(1.0) : sample->dt*config->excitation_rate);
        excited = (state->excitation > config->excitation_least ? R(1.0) : R(0.0));
        if ((excited > R(0.5)) && (live > 0) && (state->fresh > config->settle_samples)) { /* the band is excited, the filters settled */
            state->Q = state->Q*config->forgetting + psi*y - from_output*config->noise_variance*(config->noise_zero - config->noise_one);
            state->A = (psi*psi) + state->A*config->forgetting - config->noise_variance*config->noise_zero*(from_output*from_output);
            const bicycle_band_real noise_sum = config->noise_variance*config->noise_zero*(from_output*from_output)/(R(1.0) - config->forgetting); /* what noise alone would sum to */
            if (state->A > noise_sum*config->signal_least) { /* more than noise */
                state->K = state->Q/state->A;
                edge = 0;
                if ((state->K < config->K_low) || (state->K > config->K_high)) { /* no car is softer or stiffer */
                    state->K = ((state->K) > (config->K_low) ? state->K : config->K_low);
                    state->K = ((state->K) < (config->K_high) ? state->K : config->K_high);
                    edge = 1;
                }
                unknowns = R(1.0);
                state->block_score = state->block_score + psi*residual;
                state->block_weight = state->block_weight + (psi*psi);
                state->block_age = state->block_age + sample->dt;
                if (state->block_age >= config->block) { /* the block is full */
                    const bicycle_band_real counted = (state->blocks > (-R(0.5)) ? R(1.0) : R(0.0)); /* not the first */
                    state->scatter_sum = counted*((state->block_score*state->block_score) + config->block_keep*state->scatter_sum);
                    state->scatter_weight = counted*(state->block_weight + config->block_keep*state->scatter_weight);
                    state->blocks = ((config->blocks_most) < (R(1.0) + state->blocks) ? config->blocks_most : R(1.0) + state->blocks);
                    state->block_score = R(0.0);
                    state->block_weight = R(0.0);
                    state->block_age = R(0.0);
                }
                if ((state->blocks > R(2.5)) && (state->scatter_weight > R(0.015625)*state->A)) { /* enough blocks */
                    spread = ((config->scatter_low) > (state->scatter_sum/state->scatter_weight) ? config->scatter_low : state->scatter_sum/state->scatter_weight); /* variance of the residual as felt */
                    state->log_variance = ((config->variance_limit) < (spread*(R(1.0) + R(5.0)/state->blocks)/(state->A*(state->K*state->K))) ? config->variance_limit : spread*(R(1.0) + R(5.0)/state->blocks)/(state->A*(state->K*state->K)));
                    const bicycle_band_real told = (state->K*state->K)*(psi*psi)/spread; /* by this sample */
                    state->information = state->information + told;
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
        if ((excited > R(0.5)) && (live > 0) && (state->fresh > config->settle_samples)) { /* unseen, K may change */
            state->aged = state->aged*config->forgetting;
        } else {
            state->aged = ((config->variance_limit) < (state->aged + sample->dt*config->idle_drift) ? config->variance_limit : state->aged + sample->dt*config->idle_drift);
        }
        state->input_before = input_filtered;
        state->output_before = output_filtered;
        if (usable > 0) {
            state->mean_square = state->mean_square + ((innovation*innovation) - state->mean_square)*((R(1.0)) < (sample->dt*config->excitation_rate) ? R(1.0) : sample->dt*config->excitation_rate);
        }
        state->last_input = u_now;
        state->last_measured = y_now;
    } else {
        status = 7;
    }
    innovation_variance = ((state->mean_square) > (config->scatter_low) ? state->mean_square : config->scatter_low);
    estimate = state->K;
    variance = ((config->variance_limit) < (state->aged + state->log_variance) ? config->variance_limit : state->aged + state->log_variance);
    information_gained = state->information;

    output->estimate = estimate;
    output->variance = variance;
    output->predicted = predicted;
    output->innovation = innovation;
    output->innovation_variance = innovation_variance;
    output->information_gained = information_gained;
    output->unknowns = unknowns;
    return status;
}

/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int bicycle_band_step(const bicycle_band_config *config, bicycle_band_state *state,
                               const bicycle_band_sample *sample, bicycle_band_output *output)
{
    return bicycle_band_advance(config, state, sample, output);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long bicycle_band_batch(const bicycle_band_config *config, bicycle_band_state *state, long n,
                                 const bicycle_band_sample *samples, bicycle_band_output *outputs, int *status)
{
    bicycle_band_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = bicycle_band_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}
