/* Four-unknown regression behind state-variable filters of the bicycle. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle, Brennan & Alleyne 2004, eqs 1-4
 *   base: m, L, U
 *   unknown: K; frozen: pi1, eta, rho
 *   B1 = -1/(rho*(pi1 - 1))
 *   M2 = -(eta*pi1*rho - eta*pi1 + eta - pi1*rho + pi1 + rho)/(rho*(pi1 - 1))
 *   K1 = -(eta - 1)/(rho*(pi1 - 1))
 *   K2 = eta/(rho*(pi1 - 1)**2), G2 = eta/(rho*(pi1 - 1)**2)
 *
 * Operations: step 638 at most, 8 at least (arithmetic, comparisons, selects), init 38.
 * Memory: state 53 reals, configuration 39 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL bicycle_robust_real;
#define R(x) ((bicycle_robust_real)(x))

enum bicycle_robust_status {
    BICYCLE_ROBUST_OK = 0,
    BICYCLE_ROBUST_NOT_EXCITED = 1,
    BICYCLE_ROBUST_OUTSIDE_LINEAR = 2,
    BICYCLE_ROBUST_AT_LIMIT = 3,
    BICYCLE_ROBUST_NO_MEASUREMENT = 4,
    BICYCLE_ROBUST_RESTARTED = 5,
    BICYCLE_ROBUST_TOO_SLOW = 6,
    BICYCLE_ROBUST_BAD_SAMPLE = 7
};

typedef struct bicycle_robust_config {
    bicycle_robust_real L;                           /* [m] wheelbase */
    bicycle_robust_real pi1;                         /* [-] frozen a/L, position of the centre of gravity */
    bicycle_robust_real eta;                         /* [-] frozen rear over front cornering coefficient; > 1 understeers */
    bicycle_robust_real rho;                         /* [-] frozen Iz/(m a b), yaw inertia ratio */
    bicycle_robust_real sample_time;                 /* [s] sample time the filters are designed for */
    bicycle_robust_real corner;                      /* [1/s] corner of the four stages */
    bicycle_robust_real offset_rate;                 /* [1/s] rate at which offsets are followed and taken out */
    bicycle_robust_real forgetting;                  /* [-] share of the past kept at each update */
    bicycle_robust_real noise_variance;              /* [(rad/s)^2] variance of r a sample that is taken out */
    bicycle_robust_real noise_value;                 /* [-] moment of filtered unit noise: value */
    bicycle_robust_real noise_rate;                  /* [-] moment of filtered unit noise: rate */
    bicycle_robust_real noise_change;                /* [-] moment of filtered unit noise: change */
    bicycle_robust_real noise_value_rate;            /* [-] moment of filtered unit noise: value_rate */
    bicycle_robust_real noise_value_change;          /* [-] moment of filtered unit noise: value_change */
    bicycle_robust_real noise_rate_change;           /* [-] moment of filtered unit noise: rate_change */
    bicycle_robust_real signal_least;                /* [-] least pivot of four against the noise taken out of it */
    bicycle_robust_real signal_least_one;            /* [-] the same of one unknown */
    bicycle_robust_real pivot_least;                 /* [-] least share of a regressor that the others must not explain */
    bicycle_robust_real move_limit;                  /* [-] greatest move of ln K in one sample with one unknown */
    bicycle_robust_real K_start;                     /* [m^2/s^2] K before the first update */
    bicycle_robust_real K_low;                       /* [m^2/s^2] least K of the population */
    bicycle_robust_real K_high;                      /* [m^2/s^2] greatest K of the population */
    bicycle_robust_real excitation_least;            /* [-] least mean square of the drive to learn from, in its units */
    bicycle_robust_real excitation_rate;             /* [1/s] averaging rate of that mean square */
    bicycle_robust_real block;                       /* [s] length of a block of the scatter */
    bicycle_robust_real block_keep;                  /* [-] share of the older blocks kept at each new one */
    bicycle_robust_real blocks_most;                 /* [-] blocks remembered */
    bicycle_robust_real scatter_low;                 /* [-] least variance of the residual, in its units, > 0 */
    bicycle_robust_real variance_limit;              /* [-] greatest variance that is reported */
    bicycle_robust_real idle_drift;                  /* [1/s] growth of the variance while nothing is learnt */
    bicycle_robust_real settle_samples;              /* [-] whole samples in a row before an update, 3 or more */
    bicycle_robust_real dt_low;                      /* [s] shortest step that counts as one sample */
    bicycle_robust_real dt_high;                     /* [s] longest step that counts as one sample */
    bicycle_robust_real U_least;                     /* [m/s] least forward speed to learn at, > 0 */
    bicycle_robust_real input_limit;                 /* [rad] greatest believable delta */
    bicycle_robust_real output_limit;                /* [rad/s] greatest believable r */
    bicycle_robust_real output_jump;                 /* [rad/s] greatest believable change of r in one sample */
    bicycle_robust_real signal_limit;                /* [m/s] greatest believable scale */
    bicycle_robust_real validity_limit;              /* [m/s^2] edge of the model's linear range */
} bicycle_robust_config;

typedef struct bicycle_robust_state {
    bicycle_robust_real K;                           /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_robust_real input_gain;                  /* [-] B1 */
    bicycle_robust_real damping;                     /* [-] M2 */
    bicycle_robust_real stiffness;                   /* [-] K1 */
    bicycle_robust_real pair_output;                 /* [-] K2 */
    bicycle_robust_real pair_input;                  /* [-] G2 */
    bicycle_robust_real stage_keep;                  /* [-] weight of a stage's own past */
    bicycle_robust_real stage_share;                 /* [-] weight of each end of what comes in */
    bicycle_robust_real input_offset;                /* [rad] slow part of delta */
    bicycle_robust_real output_offset;               /* [rad/s] slow part of r */
    bicycle_robust_real input_stage[5];              /* [rad] delta and its four stages */
    bicycle_robust_real output_stage[5];             /* [rad/s] r and its four stages */
    bicycle_robust_real scale_stage;                 /* [m/s] forward speed as late as the stages are */
    bicycle_robust_real A[10];                       /* [-] normal matrix, unknowns 2, 3, 4, 1, upper triangle by rows */
    bicycle_robust_real q[4];                        /* [-] right-hand side, unknowns 2, 3, 4, 1 */
    bicycle_robust_real yy;                          /* [-] sum of squares of the left side */
    bicycle_robust_real weight;                      /* [-] samples the sums rest on */
    bicycle_robust_real excitation;                  /* [-] mean square of the drive, in its units */
    bicycle_robust_real mean_square;                 /* [-] mean square of the innovation, in its units */
    bicycle_robust_real block_score;                 /* [-] sum of regressor times residual over this block */
    bicycle_robust_real block_weight;                /* [-] sum of squared regressor over this block */
    bicycle_robust_real block_age;                   /* [s] age of this block */
    bicycle_robust_real scatter_sum;                 /* [-] squared scores of the blocks remembered */
    bicycle_robust_real scatter_weight;              /* [-] their weights */
    bicycle_robust_real blocks;                      /* [-] how many there are */
    bicycle_robust_real log_variance;                /* [-] variance of ln K from the scatter */
    bicycle_robust_real aged;                        /* [-] variance grown while nothing was learnt */
    bicycle_robust_real information;                 /* [-] information gained about ln K */
    bicycle_robust_real last_input;                  /* [rad] last usable input */
    bicycle_robust_real last_measured;               /* [rad/s] last usable measurement */
    bicycle_robust_real last_U;                      /* [m/s] last forward speed fast enough to learn */
    bicycle_robust_real fresh;                       /* [-] usable samples in a row */
    bicycle_robust_real started;                     /* [-] 0 before the first usable scale, 1 after */
} bicycle_robust_state;

typedef struct bicycle_robust_sample {
    bicycle_robust_real dt;                          /* [s] time since the sample before */
    bicycle_robust_real input;                       /* [rad] road-wheel steer angle */
    bicycle_robust_real U;                           /* [m/s] forward speed */
    bicycle_robust_real measured;                    /* [rad/s] measured yaw rate */
} bicycle_robust_sample;

typedef struct bicycle_robust_output {
    bicycle_robust_real estimate;                    /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_robust_real variance;                    /* [-] variance of ln K */
    bicycle_robust_real predicted;                   /* [rad/s] yaw rate predicted before the measurement */
    bicycle_robust_real innovation;                  /* [rad/s] measured minus predicted; 0 without a measurement */
    bicycle_robust_real innovation_variance;         /* [(rad/s)^2] variance of the innovation */
    bicycle_robust_real information_gained;          /* [-] information gained about ln K so far */
    bicycle_robust_real unknowns;                    /* [-] unknowns the excitation carries now; 0 while nothing is learnt */
} bicycle_robust_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void bicycle_robust_init(const bicycle_robust_config *config, bicycle_robust_state *state)
{
    bicycle_robust_real *const input_stage = state->input_stage;
    bicycle_robust_real *const output_stage = state->output_stage;
    bicycle_robust_real *const A = state->A;
    bicycle_robust_real *const q = state->q;
    int i;
    for (i = 0; i < 10; ++i) {
        A[i] = R(0.0);
    }
    state->K = config->K_start;
    state->input_gain = (-R(1.0)/(config->rho*(config->pi1 - R(1.0))));
    state->damping = (-(config->eta + config->pi1 + config->rho + config->eta*config->pi1*config->rho - config->eta*config->pi1 - config->pi1*config->rho)/(config->rho*(config->pi1 - R(1.0))));
    state->stiffness = (-(config->eta - R(1.0))/(config->rho*(config->pi1 - R(1.0))));
    state->pair_output = config->eta/(config->rho*((config->pi1 - R(1.0))*(config->pi1 - R(1.0))));
    state->pair_input = config->eta/(config->rho*((config->pi1 - R(1.0))*(config->pi1 - R(1.0))));
    state->stage_keep = (R(2.0) - config->corner*config->sample_time)/((R(2.0) + config->corner*config->sample_time));
    state->stage_share = config->corner*config->sample_time/((R(2.0) + config->corner*config->sample_time));
    state->input_offset = R(0.0);
    state->output_offset = R(0.0);
    input_stage[0] = R(0.0);
    input_stage[1] = R(0.0);
    input_stage[2] = R(0.0);
    input_stage[3] = R(0.0);
    input_stage[4] = R(0.0);
    output_stage[0] = R(0.0);
    output_stage[1] = R(0.0);
    output_stage[2] = R(0.0);
    output_stage[3] = R(0.0);
    output_stage[4] = R(0.0);
    state->scale_stage = config->U_least;
    q[0] = R(0.0);
    q[1] = R(0.0);
    q[2] = R(0.0);
    q[3] = R(0.0);
    state->yy = R(0.0);
    state->weight = R(0.0);
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
SIMILITUDE_INLINE int bicycle_robust_advance(const bicycle_robust_config *config, bicycle_robust_state *state,
                                     const bicycle_robust_sample *sample, bicycle_robust_output *output)
{
    bicycle_robust_real *const input_stage = state->input_stage;
    bicycle_robust_real *const output_stage = state->output_stage;
    bicycle_robust_real *const A = state->A;
    bicycle_robust_real *const q = state->q;
    int carried = 0;
    int edge = 0;
    bicycle_robust_real estimate = R(0.0);
    bicycle_robust_real excited = R(0.0);
    bicycle_robust_real information_gained = R(0.0);
    bicycle_robust_real innovation = R(0.0);
    bicycle_robust_real innovation_variance = R(0.0);
    int live = 0;
    bicycle_robust_real lowest = R(0.0);
    bicycle_robust_real predicted = R(0.0);
    bicycle_robust_real residual = R(0.0);
    bicycle_robust_real scale_now = R(0.0);
    bicycle_robust_real spread = R(0.0);
    int status = 0;
    bicycle_robust_real u_now = R(0.0);
    bicycle_robust_real unknowns = R(0.0);
    int usable = 0;
    bicycle_robust_real variance = R(0.0);
    bicycle_robust_real y_now = R(0.0);

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
        const bicycle_robust_real inv_L = (R(1.0)/config->L);
        const bicycle_robust_real slowly = ((R(1.0)) < (sample->dt*config->offset_rate) ? R(1.0) : sample->dt*config->offset_rate);
        state->input_offset = state->input_offset + slowly*(u_now - state->input_offset);
        state->output_offset = state->output_offset + slowly*(y_now - state->output_offset);
        const bicycle_robust_real input_0 = u_now - state->input_offset;
        const bicycle_robust_real output_0 = y_now - state->output_offset;
        const bicycle_robust_real input_1 = input_stage[1]*state->stage_keep + state->stage_share*(input_0 + input_stage[0]);
        input_stage[0] = input_0;
        const bicycle_robust_real input_2 = input_stage[2]*state->stage_keep + state->stage_share*(input_1 + input_stage[1]);
        input_stage[1] = input_1;
        const bicycle_robust_real input_3 = input_stage[3]*state->stage_keep + state->stage_share*(input_2 + input_stage[2]);
        input_stage[2] = input_2;
        const bicycle_robust_real input_4 = input_stage[4]*state->stage_keep + state->stage_share*(input_3 + input_stage[3]);
        input_stage[3] = input_3;
        input_stage[4] = input_4;
        const bicycle_robust_real output_1 = output_stage[1]*state->stage_keep + state->stage_share*(output_0 + output_stage[0]);
        output_stage[0] = output_0;
        const bicycle_robust_real output_2 = output_stage[2]*state->stage_keep + state->stage_share*(output_1 + output_stage[1]);
        output_stage[1] = output_1;
        const bicycle_robust_real output_3 = output_stage[3]*state->stage_keep + state->stage_share*(output_2 + output_stage[2]);
        output_stage[2] = output_2;
        const bicycle_robust_real output_4 = output_stage[4]*state->stage_keep + state->stage_share*(output_3 + output_stage[3]);
        output_stage[3] = output_3;
        output_stage[4] = output_4;
        state->scale_stage = (state->fresh > config->settle_samples ? state->scale_stage + R(0.25)*config->corner*config->sample_time*(state->last_U - state->scale_stage) : state->last_U); /* as late as the filtered signals */
        const bicycle_robust_real late = (R(1.0)/state->scale_stage);
        const bicycle_robust_real to_input = state->input_gain*(inv_L*inv_L);
        const bicycle_robust_real to_rate = state->damping*inv_L*late;
        const bicycle_robust_real to_output = (inv_L*inv_L);
        const bicycle_robust_real to_pair = state->pair_output*(inv_L*inv_L)*(late*late);
        const bicycle_robust_real psi_1 = config->corner*to_input*(input_3 - input_4);
        const bicycle_robust_real psi_2 = (-config->corner*to_rate*(output_3 - output_4));
        const bicycle_robust_real psi_3 = (-output_4*to_output);
        const bicycle_robust_real psi_4 = input_4*late*state->pair_input*(inv_L*inv_L*inv_L) - output_4*to_pair;
        const bicycle_robust_real y = (config->corner*config->corner)*(output_2 + output_4 - R(2.0)*output_3); /* second derivative */
        carried = 0;
        const bicycle_robust_real drive = state->K*psi_1; /* what the input alone does to the regression */
        state->excitation = state->excitation + ((drive*drive) - state->excitation)*((R(1.0)) < (sample->dt*config->excitation_rate) ? R(1.0) : sample->dt*config->excitation_rate);
        excited = (state->excitation > config->excitation_least ? R(1.0) : R(0.0));
        const bicycle_robust_real together = state->K*psi_1 + state->K*psi_2 + psi_4*(state->K*state->K) + state->K*psi_3*state->stiffness; /* of the car with this K */
        residual = y - together;
        if ((excited > R(0.5)) && (live > 0) && (state->fresh > config->settle_samples)) { /* the steer moves, the filters have settled */
            state->weight = R(1.0) + config->forgetting*state->weight;
            A[0] = (psi_2*psi_2) + A[0]*config->forgetting - config->noise_rate*config->noise_variance*(to_rate*to_rate);
            A[1] = A[1]*config->forgetting + psi_2*psi_3 - config->noise_value_rate*config->noise_variance*to_output*to_rate;
            A[2] = A[2]*config->forgetting + psi_2*psi_4 - config->noise_value_rate*config->noise_variance*to_pair*to_rate;
            A[3] = A[3]*config->forgetting + psi_1*psi_2;
            A[4] = (psi_3*psi_3) + A[4]*config->forgetting - config->noise_value*config->noise_variance*(to_output*to_output);
            A[5] = A[5]*config->forgetting + psi_3*psi_4 - config->noise_value*config->noise_variance*to_output*to_pair;
            A[6] = A[6]*config->forgetting + psi_1*psi_3;
            A[7] = (psi_4*psi_4) + A[7]*config->forgetting - config->noise_value*config->noise_variance*(to_pair*to_pair);
            A[8] = A[8]*config->forgetting + psi_1*psi_4;
            A[9] = (psi_1*psi_1) + A[9]*config->forgetting;
            q[0] = config->forgetting*q[0] + psi_2*y + config->noise_rate_change*config->noise_variance*to_rate;
            q[1] = config->forgetting*q[1] + psi_3*y + config->noise_value_change*config->noise_variance*to_output;
            q[2] = config->forgetting*q[2] + psi_4*y + config->noise_value_change*config->noise_variance*to_pair;
            q[3] = config->forgetting*q[3] + psi_1*y;
            state->yy = (y*y) + config->forgetting*state->yy - config->noise_change*config->noise_variance;
            const bicycle_robust_real noise_sum = config->noise_variance*state->weight; /* the noise's share of the sums */
            const bicycle_robust_real d_0 = A[0];
            if (d_0 > ((A[0]*config->pivot_least) > (config->noise_rate*noise_sum*config->signal_least*(to_rate*to_rate)) ? A[0]*config->pivot_least : config->noise_rate*noise_sum*config->signal_least*(to_rate*to_rate))) {
                const bicycle_robust_real inv_d_0 = (R(1.0)/d_0);
                const bicycle_robust_real z_0 = q[0];
                const bicycle_robust_real w_0 = psi_2;
                const bicycle_robust_real part_0 = inv_d_0*w_0*z_0;
                const bicycle_robust_real u_10 = A[1];
                const bicycle_robust_real l_10 = inv_d_0*u_10;
                const bicycle_robust_real d_1 = A[4] - l_10*u_10;
                if (d_1 > ((A[4]*config->pivot_least) > (noise_sum*config->noise_value*config->signal_least*(to_output*to_output)) ? A[4]*config->pivot_least : noise_sum*config->noise_value*config->signal_least*(to_output*to_output))) {
                    const bicycle_robust_real inv_d_1 = (R(1.0)/d_1);
                    const bicycle_robust_real z_1 = q[1] - l_10*z_0;
                    const bicycle_robust_real w_1 = psi_3 - l_10*w_0;
                    const bicycle_robust_real part_1 = inv_d_1*w_1*z_1;
                    const bicycle_robust_real u_20 = A[2];
                    const bicycle_robust_real l_20 = inv_d_0*u_20;
                    const bicycle_robust_real u_21 = A[5] - l_20*u_10;
                    const bicycle_robust_real l_21 = inv_d_1*u_21;
                    const bicycle_robust_real d_2 = A[7] - l_20*u_20 - l_21*u_21;
                    if (d_2 > ((A[7]*config->pivot_least) > (noise_sum*config->noise_value*config->signal_least*(to_pair*to_pair)) ? A[7]*config->pivot_least : noise_sum*config->noise_value*config->signal_least*(to_pair*to_pair))) {
                        const bicycle_robust_real inv_d_2 = (R(1.0)/d_2);
                        const bicycle_robust_real z_2 = q[2] - l_20*z_0 - l_21*z_1;
                        const bicycle_robust_real w_2 = psi_4 - l_20*w_0 - l_21*w_1;
                        const bicycle_robust_real part_2 = inv_d_2*w_2*z_2;
                        const bicycle_robust_real u_30 = A[3];
                        const bicycle_robust_real l_30 = inv_d_0*u_30;
                        const bicycle_robust_real u_31 = A[6] - l_30*u_10;
                        const bicycle_robust_real l_31 = inv_d_1*u_31;
                        const bicycle_robust_real u_32 = A[8] - l_30*u_20 - l_31*u_21;
                        const bicycle_robust_real l_32 = inv_d_2*u_32;
                        const bicycle_robust_real d_3 = A[9] - l_30*u_30 - l_31*u_31 - l_32*u_32;
                        if (d_3 > ((R(0.0)) > (A[9]*config->pivot_least) ? R(0.0) : A[9]*config->pivot_least)) { /* every unknown is carried */
                            const bicycle_robust_real inv_d_3 = (R(1.0)/d_3);
                            const bicycle_robust_real z_3 = q[3] - l_30*z_0 - l_31*z_1 - l_32*z_2;
                            const bicycle_robust_real w_3 = psi_1 - l_30*w_0 - l_31*w_1 - l_32*w_2;
                            const bicycle_robust_real part_3 = inv_d_3*w_3*z_3;
                            state->K = inv_d_3*z_3;
                            edge = 0;
                            if ((state->K < config->K_low) || (state->K > config->K_high)) { /* no car is softer or stiffer */
                                state->K = ((state->K) > (config->K_low) ? state->K : config->K_low);
                                state->K = ((state->K) < (config->K_high) ? state->K : config->K_high);
                                edge = 1;
                            }
                            carried = 4;
                            unknowns = R(4.0);
                            residual = y - part_0 - part_1 - part_2 - part_3;
                            state->block_score = state->block_score + residual*w_3;
                            state->block_weight = state->block_weight + (w_3*w_3);
                            state->block_age = state->block_age + sample->dt;
                            if (state->block_age >= config->block) { /* the block is full */
                                const bicycle_robust_real counted = (state->blocks > (-R(0.5)) ? R(1.0) : R(0.0)); /* not the first */
                                state->scatter_sum = counted*((state->block_score*state->block_score) + config->block_keep*state->scatter_sum);
                                state->scatter_weight = counted*(state->block_weight + config->block_keep*state->scatter_weight);
                                state->blocks = ((config->blocks_most) < (R(1.0) + state->blocks) ? config->blocks_most : R(1.0) + state->blocks);
                                state->block_score = R(0.0);
                                state->block_weight = R(0.0);
                                state->block_age = R(0.0);
                            }
                            if ((state->blocks > R(2.5)) && (state->scatter_weight > R(0.015625)*d_3)) { /* enough blocks */
                                spread = ((config->scatter_low) > (state->scatter_sum/state->scatter_weight) ? config->scatter_low : state->scatter_sum/state->scatter_weight); /* variance of the residual as felt */
                                state->log_variance = ((config->variance_limit) < (spread*(R(1.0) + R(5.0)/state->blocks)/((state->K*state->K)*d_3)) ? config->variance_limit : spread*(R(1.0) + R(5.0)/state->blocks)/((state->K*state->K)*d_3));
                                const bicycle_robust_real told = (state->K*state->K)*(w_3*w_3)/spread; /* by this sample */
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
                }
            }
            if (carried < 1) { /* the steer says less */
                const bicycle_robust_real c2 = A[0] + R(2.0)*A[3] + A[9] + R(2.0)*A[1]*state->stiffness + A[4]*(state->stiffness*state->stiffness) + R(2.0)*A[6]*state->stiffness;
                const bicycle_robust_real c3 = A[2] + A[8] + A[5]*state->stiffness;
                const bicycle_robust_real c4 = A[7];
                const bicycle_robust_real d1 = q[0] + q[3] + q[1]*state->stiffness;
                const bicycle_robust_real d2 = q[2];
                lowest = state->yy + state->K*(state->K*(c2 + state->K*(R(2.0)*c3 + state->K*c4) - R(2.0)*d2) - R(2.0)*d1);
                const bicycle_robust_real place_0 = R(0.5)*config->K_start;
                const bicycle_robust_real cost_0 = state->yy + place_0*(place_0*(c2 + place_0*(R(2.0)*c3 + c4*place_0) - R(2.0)*d2) - R(2.0)*d1);
                if (cost_0*(state->K*state->K) < lowest*(place_0*place_0)) { /* another valley */
                    state->K = place_0;
                    lowest = cost_0;
                }
                const bicycle_robust_real place_1 = R(0.7)*config->K_start;
                const bicycle_robust_real cost_1 = state->yy + place_1*(place_1*(c2 + place_1*(R(2.0)*c3 + c4*place_1) - R(2.0)*d2) - R(2.0)*d1);
                if (cost_1*(state->K*state->K) < lowest*(place_1*place_1)) {
                    state->K = place_1;
                    lowest = cost_1;
                }
                const bicycle_robust_real place_2 = config->K_start;
                const bicycle_robust_real cost_2 = state->yy + place_2*(place_2*(c2 + place_2*(R(2.0)*c3 + c4*place_2) - R(2.0)*d2) - R(2.0)*d1);
                if (cost_2*(state->K*state->K) < lowest*(place_2*place_2)) {
                    state->K = place_2;
                    lowest = cost_2;
                }
                const bicycle_robust_real place_3 = R(1.4)*config->K_start;
                const bicycle_robust_real cost_3 = state->yy + place_3*(place_3*(c2 + place_3*(R(2.0)*c3 + c4*place_3) - R(2.0)*d2) - R(2.0)*d1);
                if (cost_3*(state->K*state->K) < lowest*(place_3*place_3)) {
                    state->K = place_3;
                    lowest = cost_3;
                }
                const bicycle_robust_real place_4 = R(2.0)*config->K_start;
                const bicycle_robust_real cost_4 = state->yy + place_4*(place_4*(c2 + place_4*(R(2.0)*c3 + c4*place_4) - R(2.0)*d2) - R(2.0)*d1);
                if (cost_4*(state->K*state->K) < lowest*(place_4*place_4)) {
                    state->K = place_4;
                    lowest = cost_4;
                }
                const bicycle_robust_real slow = R(2.0)*state->K*to_pair + state->stiffness*to_output;
                const bicycle_robust_real noise_along = config->noise_value*(slow*slow) + to_rate*(config->noise_rate*to_rate + R(2.0)*config->noise_value_rate*slow);
                const bicycle_robust_real psi = psi_1 + psi_2 + R(2.0)*state->K*psi_4 + psi_3*state->stiffness;
                const bicycle_robust_real normal = c2 + R(4.0)*state->K*(c3 + state->K*c4);
                const bicycle_robust_real wanted = d1 - state->K*(c2 + state->K*(R(3.0)*c3 + R(2.0)*state->K*c4) - R(2.0)*d2);
                if ((normal > R(0.0)) && (normal > noise_along*noise_sum*config->signal_least_one)) { /* more than noise */
                    state->K = state->K + (((-state->K*config->move_limit)) > (((state->K*config->move_limit) < (wanted/normal) ? state->K*config->move_limit : wanted/normal)) ? (-state->K*config->move_limit) : ((state->K*config->move_limit) < (wanted/normal) ? state->K*config->move_limit : wanted/normal));
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
                        const bicycle_robust_real counted = (state->blocks > (-R(0.5)) ? R(1.0) : R(0.0)); /* not the first */
                        state->scatter_sum = counted*((state->block_score*state->block_score) + config->block_keep*state->scatter_sum);
                        state->scatter_weight = counted*(state->block_weight + config->block_keep*state->scatter_weight);
                        state->blocks = ((config->blocks_most) < (R(1.0) + state->blocks) ? config->blocks_most : R(1.0) + state->blocks);
                        state->block_score = R(0.0);
                        state->block_weight = R(0.0);
                        state->block_age = R(0.0);
                    }
                    if ((state->blocks > R(2.5)) && (state->scatter_weight > R(0.015625)*normal)) { /* enough blocks */
                        spread = ((config->scatter_low) > (state->scatter_sum/state->scatter_weight) ? config->scatter_low : state->scatter_sum/state->scatter_weight); /* variance of the residual as felt */
                        state->log_variance = ((config->variance_limit) < (spread*(R(1.0) + R(5.0)/state->blocks)/((state->K*state->K)*normal)) ? config->variance_limit : spread*(R(1.0) + R(5.0)/state->blocks)/((state->K*state->K)*normal));
                        const bicycle_robust_real told = (state->K*state->K)*(psi*psi)/spread; /* by this sample */
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
        }
        innovation = (usable > 0 ? residual/config->corner : R(0.0));
        predicted = y_now - innovation;
        if ((excited > R(0.5)) && (live > 0) && (state->fresh > config->settle_samples)) { /* unseen, K may change */
            state->aged = state->aged*config->forgetting;
        } else {
            state->aged = ((config->variance_limit) < (state->aged + sample->dt*config->idle_drift) ? config->variance_limit : state->aged + sample->dt*config->idle_drift);
        }
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
SIMILITUDE_API int bicycle_robust_step(const bicycle_robust_config *config, bicycle_robust_state *state,
                               const bicycle_robust_sample *sample, bicycle_robust_output *output)
{
    return bicycle_robust_advance(config, state, sample, output);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long bicycle_robust_batch(const bicycle_robust_config *config, bicycle_robust_state *state, long n,
                                 const bicycle_robust_sample *samples, bicycle_robust_output *outputs, int *status)
{
    bicycle_robust_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = bicycle_robust_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}
