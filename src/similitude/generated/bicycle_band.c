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
    const bicycle_band_real pi1 = config->pi1;
    const bicycle_band_real eta = config->eta;
    const bicycle_band_real rho = config->rho;
    const bicycle_band_real sample_time = config->sample_time;
    const bicycle_band_real K_start = config->K_start;
    const bicycle_band_real variance_limit = config->variance_limit;
    const bicycle_band_real U_least = config->U_least;
    bicycle_band_real *const input_memory = state->input_memory;
    bicycle_band_real *const output_memory = state->output_memory;
    bicycle_band_real A;
    bicycle_band_real K;
    bicycle_band_real Q;
    bicycle_band_real aged;
    bicycle_band_real block_age;
    bicycle_band_real block_score;
    bicycle_band_real block_weight;
    bicycle_band_real blocks;
    bicycle_band_real damping;
    bicycle_band_real excitation;
    bicycle_band_real fresh;
    bicycle_band_real information;
    bicycle_band_real input_before;
    bicycle_band_real input_gain;
    bicycle_band_real last_U;
    bicycle_band_real last_input;
    bicycle_band_real last_measured;
    bicycle_band_real log_variance;
    bicycle_band_real mean_square;
    bicycle_band_real output_before;
    bicycle_band_real scatter_sum;
    bicycle_band_real scatter_weight;
    bicycle_band_real started;
    K = K_start;
    input_gain = (-sample_time/(rho*(pi1 - R(1.0))));
    damping = (-sample_time*(eta + pi1 + rho + eta*pi1*rho - eta*pi1 - pi1*rho)/(rho*(pi1 - R(1.0))));
    Q = R(0.0);
    A = R(0.0);
    input_memory[0] = R(0.0);
    input_memory[1] = R(0.0);
    input_memory[2] = R(0.0);
    input_memory[3] = R(0.0);
    input_memory[4] = R(0.0);
    input_memory[5] = R(0.0);
    input_memory[6] = R(0.0);
    input_memory[7] = R(0.0);
    output_memory[0] = R(0.0);
    output_memory[1] = R(0.0);
    output_memory[2] = R(0.0);
    output_memory[3] = R(0.0);
    output_memory[4] = R(0.0);
    output_memory[5] = R(0.0);
    output_memory[6] = R(0.0);
    output_memory[7] = R(0.0);
    input_before = R(0.0);
    output_before = R(0.0);
    excitation = R(0.0);
    mean_square = R(0.0);
    block_score = R(0.0);
    block_weight = R(0.0);
    block_age = R(0.0);
    scatter_sum = R(0.0);
    scatter_weight = R(0.0);
    blocks = (-R(1.0));
    log_variance = variance_limit;
    aged = R(0.0);
    information = R(0.0);
    last_input = R(0.0);
    last_measured = R(0.0);
    last_U = U_least;
    fresh = R(0.0);
    started = R(0.0);
    state->K = K;
    state->input_gain = input_gain;
    state->damping = damping;
    state->Q = Q;
    state->A = A;
    state->input_before = input_before;
    state->output_before = output_before;
    state->excitation = excitation;
    state->mean_square = mean_square;
    state->block_score = block_score;
    state->block_weight = block_weight;
    state->block_age = block_age;
    state->scatter_sum = scatter_sum;
    state->scatter_weight = scatter_weight;
    state->blocks = blocks;
    state->log_variance = log_variance;
    state->aged = aged;
    state->information = information;
    state->last_input = last_input;
    state->last_measured = last_measured;
    state->last_U = last_U;
    state->fresh = fresh;
    state->started = started;
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_band_advance(const bicycle_band_config *config, bicycle_band_state *state,
                                     const bicycle_band_sample *sample, bicycle_band_output *output)
{
    const bicycle_band_real L = config->L;
    const bicycle_band_real biquad_1_0 = config->biquad_1[0];
    const bicycle_band_real biquad_1_1 = config->biquad_1[1];
    const bicycle_band_real biquad_1_2 = config->biquad_1[2];
    const bicycle_band_real biquad_1_3 = config->biquad_1[3];
    const bicycle_band_real biquad_1_4 = config->biquad_1[4];
    const bicycle_band_real biquad_2_0 = config->biquad_2[0];
    const bicycle_band_real biquad_2_1 = config->biquad_2[1];
    const bicycle_band_real biquad_2_2 = config->biquad_2[2];
    const bicycle_band_real biquad_2_3 = config->biquad_2[3];
    const bicycle_band_real biquad_2_4 = config->biquad_2[4];
    const bicycle_band_real biquad_3_0 = config->biquad_3[0];
    const bicycle_band_real biquad_3_1 = config->biquad_3[1];
    const bicycle_band_real biquad_3_2 = config->biquad_3[2];
    const bicycle_band_real biquad_3_3 = config->biquad_3[3];
    const bicycle_band_real biquad_3_4 = config->biquad_3[4];
    const bicycle_band_real biquad_4_0 = config->biquad_4[0];
    const bicycle_band_real biquad_4_1 = config->biquad_4[1];
    const bicycle_band_real biquad_4_2 = config->biquad_4[2];
    const bicycle_band_real biquad_4_3 = config->biquad_4[3];
    const bicycle_band_real biquad_4_4 = config->biquad_4[4];
    const bicycle_band_real forgetting = config->forgetting;
    const bicycle_band_real noise_variance = config->noise_variance;
    const bicycle_band_real noise_zero = config->noise_zero;
    const bicycle_band_real noise_one = config->noise_one;
    const bicycle_band_real signal_least = config->signal_least;
    const bicycle_band_real K_low = config->K_low;
    const bicycle_band_real K_high = config->K_high;
    const bicycle_band_real excitation_least = config->excitation_least;
    const bicycle_band_real excitation_rate = config->excitation_rate;
    const bicycle_band_real block = config->block;
    const bicycle_band_real block_keep = config->block_keep;
    const bicycle_band_real blocks_most = config->blocks_most;
    const bicycle_band_real scatter_low = config->scatter_low;
    const bicycle_band_real variance_limit = config->variance_limit;
    const bicycle_band_real idle_drift = config->idle_drift;
    const bicycle_band_real settle_samples = config->settle_samples;
    const bicycle_band_real dt_low = config->dt_low;
    const bicycle_band_real dt_high = config->dt_high;
    const bicycle_band_real U_least = config->U_least;
    const bicycle_band_real input_limit = config->input_limit;
    const bicycle_band_real output_limit = config->output_limit;
    const bicycle_band_real output_jump = config->output_jump;
    const bicycle_band_real signal_limit = config->signal_limit;
    const bicycle_band_real validity_limit = config->validity_limit;
    const bicycle_band_real dt = sample->dt;
    const bicycle_band_real input = sample->input;
    const bicycle_band_real U = sample->U;
    const bicycle_band_real measured = sample->measured;
    bicycle_band_real *const input_memory = state->input_memory;
    bicycle_band_real *const output_memory = state->output_memory;
    bicycle_band_real K = state->K;
    bicycle_band_real input_gain = state->input_gain;
    bicycle_band_real damping = state->damping;
    bicycle_band_real Q = state->Q;
    bicycle_band_real A = state->A;
    bicycle_band_real input_before = state->input_before;
    bicycle_band_real output_before = state->output_before;
    bicycle_band_real excitation = state->excitation;
    bicycle_band_real mean_square = state->mean_square;
    bicycle_band_real block_score = state->block_score;
    bicycle_band_real block_weight = state->block_weight;
    bicycle_band_real block_age = state->block_age;
    bicycle_band_real scatter_sum = state->scatter_sum;
    bicycle_band_real scatter_weight = state->scatter_weight;
    bicycle_band_real blocks = state->blocks;
    bicycle_band_real log_variance = state->log_variance;
    bicycle_band_real aged = state->aged;
    bicycle_band_real information = state->information;
    bicycle_band_real last_input = state->last_input;
    bicycle_band_real last_measured = state->last_measured;
    bicycle_band_real last_U = state->last_U;
    bicycle_band_real fresh = state->fresh;
    bicycle_band_real started = state->started;
    bicycle_band_real edge = R(0.0);
    bicycle_band_real estimate = R(0.0);
    bicycle_band_real excited = R(0.0);
    bicycle_band_real information_gained = R(0.0);
    bicycle_band_real innovation = R(0.0);
    bicycle_band_real innovation_variance = R(0.0);
    bicycle_band_real live = R(0.0);
    bicycle_band_real predicted = R(0.0);
    bicycle_band_real scale_now = R(0.0);
    bicycle_band_real spread = R(0.0);
    bicycle_band_real status = R(0.0);
    bicycle_band_real u_now = R(0.0);
    bicycle_band_real unknowns = R(0.0);
    bicycle_band_real usable = R(0.0);
    bicycle_band_real variance = R(0.0);
    bicycle_band_real y_now = R(0.0);

    predicted = last_measured;
    innovation = R(0.0);
    unknowns = R(0.0);
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
        const bicycle_band_real at_U = last_U;
        const bicycle_band_real inv_U = (R(1.0)/at_U);
        const bicycle_band_real inv_L = (R(1.0)/L);
        const bicycle_band_real input_after_1 = input_memory[0] + biquad_1_0*u_now;
        input_memory[0] = input_memory[1] + biquad_1_1*u_now - biquad_1_3*input_after_1;
        input_memory[1] = biquad_1_2*u_now - biquad_1_4*input_after_1;
        const bicycle_band_real input_after_2 = input_memory[2] + biquad_2_0*input_after_1;
        input_memory[2] = input_memory[3] + biquad_2_1*input_after_1 - biquad_2_3*input_after_2;
        input_memory[3] = biquad_2_2*input_after_1 - biquad_2_4*input_after_2;
        const bicycle_band_real input_after_3 = input_memory[4] + biquad_3_0*input_after_2;
        input_memory[4] = input_memory[5] + biquad_3_1*input_after_2 - biquad_3_3*input_after_3;
        input_memory[5] = biquad_3_2*input_after_2 - biquad_3_4*input_after_3;
        const bicycle_band_real input_filtered = input_memory[6] + biquad_4_0*input_after_3;
        input_memory[6] = input_memory[7] + biquad_4_1*input_after_3 - biquad_4_3*input_filtered;
        input_memory[7] = biquad_4_2*input_after_3 - biquad_4_4*input_filtered;
        const bicycle_band_real output_after_1 = output_memory[0] + biquad_1_0*y_now;
        output_memory[0] = output_memory[1] + biquad_1_1*y_now - biquad_1_3*output_after_1;
        output_memory[1] = biquad_1_2*y_now - biquad_1_4*output_after_1;
        const bicycle_band_real output_after_2 = output_memory[2] + biquad_2_0*output_after_1;
        output_memory[2] = output_memory[3] + biquad_2_1*output_after_1 - biquad_2_3*output_after_2;
        output_memory[3] = biquad_2_2*output_after_1 - biquad_2_4*output_after_2;
        const bicycle_band_real output_after_3 = output_memory[4] + biquad_3_0*output_after_2;
        output_memory[4] = output_memory[5] + biquad_3_1*output_after_2 - biquad_3_3*output_after_3;
        output_memory[5] = biquad_3_2*output_after_2 - biquad_3_4*output_after_3;
        const bicycle_band_real output_filtered = output_memory[6] + biquad_4_0*output_after_3;
        output_memory[6] = output_memory[7] + biquad_4_1*output_after_3 - biquad_4_3*output_filtered;
        output_memory[7] = biquad_4_2*output_after_3 - biquad_4_4*output_filtered;
        const bicycle_band_real from_input = input_gain*(inv_L*inv_L); /* psi per input */
        const bicycle_band_real from_output = damping*inv_L*inv_U; /* -psi per output */
        const bicycle_band_real driven = from_input*input_before;
        const bicycle_band_real psi = driven - from_output*output_before;
        const bicycle_band_real y = output_filtered - output_before;
        const bicycle_band_real residual = y - K*psi;
        innovation = (usable > R(0.5) ? residual : R(0.0));
        predicted = y_now - innovation;
        const bicycle_band_real drive = K*driven; /* what the input alone does to the regression */
        excitation = excitation + ((drive*drive) - excitation)*((R(1.0)) < (dt*excitation_rate) ? R(1.0) : dt*excitation_rate);
        excited = (excitation > excitation_least ? R(1.0) : R(0.0));
        if ((excited > R(0.5)) && (fresh > settle_samples) && (live > R(0.5))) { /* the band is excited, the filters settled */
            Q = Q*forgetting + psi*y - from_output*noise_variance*(noise_zero - noise_one);
            A = (psi*psi) + A*forgetting - noise_variance*noise_zero*(from_output*from_output);
            const bicycle_band_real noise_sum = noise_variance*noise_zero*(from_output*from_output)/(R(1.0) - forgetting); /* what noise alone would sum to */
            if (A > noise_sum*signal_least) { /* more than noise */
                K = Q/A;
                edge = R(0.0);
                if ((K < K_low) || (K > K_high)) { /* no car is softer or stiffer */
                    K = ((K) > (K_low) ? K : K_low);
                    K = ((K) < (K_high) ? K : K_high);
                    edge = R(1.0);
                }
                unknowns = R(1.0);
                block_score = block_score + psi*residual;
                block_weight = block_weight + (psi*psi);
                block_age = block_age + dt;
                if (block_age >= block) { /* the block is full */
                    const bicycle_band_real counted = (blocks > (-R(0.5)) ? R(1.0) : R(0.0)); /* not the first */
                    scatter_sum = counted*((block_score*block_score) + block_keep*scatter_sum);
                    scatter_weight = counted*(block_weight + block_keep*scatter_weight);
                    blocks = ((blocks_most) < (R(1.0) + blocks) ? blocks_most : R(1.0) + blocks);
                    block_score = R(0.0);
                    block_weight = R(0.0);
                    block_age = R(0.0);
                }
                if ((A > R(0.0)) && (blocks > R(2.5)) && (scatter_weight > R(0.0))) { /* enough blocks */
                    spread = ((scatter_low) > (scatter_sum/scatter_weight) ? scatter_low : scatter_sum/scatter_weight); /* variance of the residual as felt */
                    log_variance = ((variance_limit) < (spread*(R(1.0) + R(5.0)/blocks)/(A*(K*K))) ? variance_limit : spread*(R(1.0) + R(5.0)/blocks)/(A*(K*K)));
                    const bicycle_band_real told = (K*K)*(psi*psi)/spread; /* by this sample */
                    information = information + told;
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
        if ((excited > R(0.5)) && (fresh > settle_samples) && (live > R(0.5))) { /* unseen, K may change */
            aged = aged*forgetting;
        } else {
            aged = ((variance_limit) < (aged + dt*idle_drift) ? variance_limit : aged + dt*idle_drift);
        }
        input_before = input_filtered;
        output_before = output_filtered;
        if (usable > R(0.5)) {
            mean_square = mean_square + ((innovation*innovation) - mean_square)*((R(1.0)) < (dt*excitation_rate) ? R(1.0) : dt*excitation_rate);
        }
        last_input = u_now;
        last_measured = y_now;
    } else {
        status = R(7.0);
    }
    innovation_variance = ((mean_square) > (scatter_low) ? mean_square : scatter_low);
    estimate = K;
    variance = ((variance_limit) < (aged + log_variance) ? variance_limit : aged + log_variance);
    information_gained = information;

    state->K = K;
    state->Q = Q;
    state->A = A;
    state->input_before = input_before;
    state->output_before = output_before;
    state->excitation = excitation;
    state->mean_square = mean_square;
    state->block_score = block_score;
    state->block_weight = block_weight;
    state->block_age = block_age;
    state->scatter_sum = scatter_sum;
    state->scatter_weight = scatter_weight;
    state->blocks = blocks;
    state->log_variance = log_variance;
    state->aged = aged;
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
    output->unknowns = unknowns;
    return (int)status;
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
