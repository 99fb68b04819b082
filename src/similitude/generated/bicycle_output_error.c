/* Recursive prediction error method of the bicycle. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle, Brennan & Alleyne 2004, eqs 1-4
 *   base: m, L, U
 *   unknown: K; frozen: pi1, eta, rho
 *   one implicit step a sample: similitude.sampling
 *
 * Operations: step 393 at most, 8 at least (arithmetic, comparisons, selects), init 22.
 * Memory: state 28 reals, configuration 32 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL bicycle_output_error_real;
#define R(x) ((bicycle_output_error_real)(x))

enum bicycle_output_error_status {
    BICYCLE_OUTPUT_ERROR_OK = 0,
    BICYCLE_OUTPUT_ERROR_NOT_EXCITED = 1,
    BICYCLE_OUTPUT_ERROR_OUTSIDE_LINEAR = 2,
    BICYCLE_OUTPUT_ERROR_AT_LIMIT = 3,
    BICYCLE_OUTPUT_ERROR_NO_MEASUREMENT = 4,
    BICYCLE_OUTPUT_ERROR_RESTARTED = 5,
    BICYCLE_OUTPUT_ERROR_TOO_SLOW = 6,
    BICYCLE_OUTPUT_ERROR_BAD_SAMPLE = 7
};

typedef struct bicycle_output_error_config {
    bicycle_output_error_real L;                     /* [m] wheelbase */
    bicycle_output_error_real pi1;                   /* [-] frozen a/L, position of the centre of gravity */
    bicycle_output_error_real eta;                   /* [-] frozen rear over front cornering coefficient; > 1 understeers */
    bicycle_output_error_real rho;                   /* [-] frozen Iz/(m a b), yaw inertia ratio */
    bicycle_output_error_real forgetting_rate;       /* [1/s] rate at which the past is forgotten */
    bicycle_output_error_real noise_variance;        /* [(rad/s)^2] variance of r a sample, > 0 */
    bicycle_output_error_real start_variance;        /* [-] variance of ln K before the first update, > 0 */
    bicycle_output_error_real observer_rate;         /* [1/s] pull of the model towards the measurement */
    bicycle_output_error_real observer_margin;       /* [1/s^2] stiffness of the motion below which the pull is raised */
    bicycle_output_error_real offset_rate;           /* [1/s] rate at which offsets are followed and taken out */
    bicycle_output_error_real state_limit;           /* [-] greatest dimensionless state */
    bicycle_output_error_real move_limit;            /* [-] greatest move of ln K in one sample */
    bicycle_output_error_real K_start;               /* [m^2/s^2] K before the first update */
    bicycle_output_error_real K_low;                 /* [m^2/s^2] least K of the population */
    bicycle_output_error_real K_high;                /* [m^2/s^2] greatest K of the population */
    bicycle_output_error_real excitation_least;      /* [-] least mean square of the drive to learn from, in its units */
    bicycle_output_error_real excitation_rate;       /* [1/s] averaging rate of that mean square */
    bicycle_output_error_real block;                 /* [s] length of a block of the scatter */
    bicycle_output_error_real block_keep;            /* [-] share of the older blocks kept at each new one */
    bicycle_output_error_real blocks_most;           /* [-] blocks remembered */
    bicycle_output_error_real scatter_low;           /* [-] least variance of the residual, in its units, > 0 */
    bicycle_output_error_real variance_limit;        /* [-] greatest variance that is reported */
    bicycle_output_error_real idle_drift;            /* [1/s] growth of the variance while nothing is learnt */
    bicycle_output_error_real settle_samples;        /* [-] whole samples in a row before an update, 3 or more */
    bicycle_output_error_real dt_low;                /* [s] shortest step that counts as one sample */
    bicycle_output_error_real dt_high;               /* [s] longest step that counts as one sample */
    bicycle_output_error_real U_least;               /* [m/s] least forward speed to learn at, > 0 */
    bicycle_output_error_real input_limit;           /* [rad] greatest believable delta */
    bicycle_output_error_real output_limit;          /* [rad/s] greatest believable r */
    bicycle_output_error_real output_jump;           /* [rad/s] greatest believable change of r in one sample */
    bicycle_output_error_real signal_limit;          /* [m/s] greatest believable scale */
    bicycle_output_error_real validity_limit;        /* [m/s^2] edge of the model's linear range */
} bicycle_output_error_config;

typedef struct bicycle_output_error_state {
    bicycle_output_error_real K;                     /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_output_error_real v_star;                /* [-] dimensionless state of the model */
    bicycle_output_error_real r_star;                /* [-] dimensionless state of the model */
    bicycle_output_error_real v_star_slope;          /* [-] its sensitivity to the logarithm */
    bicycle_output_error_real r_star_slope;          /* [-] its sensitivity to the logarithm */
    bicycle_output_error_real damping;               /* [-] M2 */
    bicycle_output_error_real stiffness;             /* [-] K1 */
    bicycle_output_error_real pair_output;           /* [-] K2 */
    bicycle_output_error_real scale_before;          /* [m/s] scale of the sample before */
    bicycle_output_error_real A;                     /* [(rad/s)^2] sum of squared sensitivity */
    bicycle_output_error_real error_offset;          /* [rad/s] slow part of the error */
    bicycle_output_error_real slope_offset;          /* [rad/s] slow part of the sensitivity */
    bicycle_output_error_real excitation;            /* [-] mean square of the drive, in its units */
    bicycle_output_error_real mean_square;           /* [-] mean square of the innovation, in its units */
    bicycle_output_error_real block_score;           /* [-] sum of regressor times residual over this block */
    bicycle_output_error_real block_weight;          /* [-] sum of squared regressor over this block */
    bicycle_output_error_real block_age;             /* [s] age of this block */
    bicycle_output_error_real scatter_sum;           /* [-] squared scores of the blocks remembered */
    bicycle_output_error_real scatter_weight;        /* [-] their weights */
    bicycle_output_error_real blocks;                /* [-] how many there are */
    bicycle_output_error_real log_variance;          /* [-] variance of ln K from the scatter */
    bicycle_output_error_real aged;                  /* [-] variance grown while nothing was learnt */
    bicycle_output_error_real information;           /* [-] information gained about ln K */
    bicycle_output_error_real last_input;            /* [rad] last usable input */
    bicycle_output_error_real last_measured;         /* [rad/s] last usable measurement */
    bicycle_output_error_real last_U;                /* [m/s] last forward speed fast enough to learn */
    bicycle_output_error_real fresh;                 /* [-] usable samples in a row */
    bicycle_output_error_real started;               /* [-] 0 before the first usable scale, 1 after */
} bicycle_output_error_state;

typedef struct bicycle_output_error_sample {
    bicycle_output_error_real dt;                    /* [s] time since the sample before */
    bicycle_output_error_real input;                 /* [rad] road-wheel steer angle */
    bicycle_output_error_real U;                     /* [m/s] forward speed */
    bicycle_output_error_real measured;              /* [rad/s] measured yaw rate */
} bicycle_output_error_sample;

typedef struct bicycle_output_error_output {
    bicycle_output_error_real estimate;              /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_output_error_real variance;              /* [-] variance of ln K */
    bicycle_output_error_real predicted;             /* [rad/s] yaw rate predicted before the measurement */
    bicycle_output_error_real innovation;            /* [rad/s] measured minus predicted; 0 without a measurement */
    bicycle_output_error_real innovation_variance;   /* [(rad/s)^2] variance of the innovation */
    bicycle_output_error_real information_gained;    /* [-] information gained about ln K so far */
    bicycle_output_error_real unknowns;              /* [-] unknowns the excitation carries now; 0 while nothing is learnt */
} bicycle_output_error_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void bicycle_output_error_init(const bicycle_output_error_config *config, bicycle_output_error_state *state)
{
    state->K = config->K_start;
    state->v_star = R(0.0);
    state->r_star = R(0.0);
    state->v_star_slope = R(0.0);
    state->r_star_slope = R(0.0);
    state->damping = (-(config->eta + config->pi1 + config->rho + config->eta*config->pi1*config->rho - config->eta*config->pi1 - config->pi1*config->rho)/(config->rho*(config->pi1 - R(1.0))));
    state->stiffness = (-(config->eta - R(1.0))/(config->rho*(config->pi1 - R(1.0))));
    state->pair_output = config->eta/(config->rho*((config->pi1 - R(1.0))*(config->pi1 - R(1.0))));
    state->scale_before = config->U_least;
    state->A = config->noise_variance/config->start_variance;
    state->error_offset = R(0.0);
    state->slope_offset = R(0.0);
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
SIMILITUDE_INLINE int bicycle_output_error_advance(const bicycle_output_error_config *config, bicycle_output_error_state *state,
                                     const bicycle_output_error_sample *sample, bicycle_output_error_output *output)
{
    int anew = 0;
    int edge = 0;
    bicycle_output_error_real estimate = R(0.0);
    bicycle_output_error_real excited = R(0.0);
    bicycle_output_error_real information_gained = R(0.0);
    bicycle_output_error_real innovation = R(0.0);
    bicycle_output_error_real innovation_variance = R(0.0);
    int live = 0;
    bicycle_output_error_real predicted = R(0.0);
    bicycle_output_error_real scale_now = R(0.0);
    bicycle_output_error_real spread = R(0.0);
    int status = 0;
    bicycle_output_error_real u_now = R(0.0);
    bicycle_output_error_real unknowns = R(0.0);
    bicycle_output_error_real usable = R(0.0);
    bicycle_output_error_real variance = R(0.0);
    bicycle_output_error_real y_now = R(0.0);

    predicted = state->last_measured;
    innovation = R(0.0);
    unknowns = R(0.0);
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
        const bicycle_output_error_real at_U = state->last_U;
        const bicycle_output_error_real inv_U = (R(1.0)/at_U);
        const bicycle_output_error_real inv_L = (R(1.0)/config->L);
        anew = 0;
        if ((state->r_star < (-config->state_limit)) || (state->r_star > config->state_limit) || (state->v_star < (-config->state_limit)) || (state->v_star > config->state_limit)) {
            anew = 1;
            status = 5;
        }
        if ((anew > 0) || (live < 1) || (sample->dt > config->dt_high)) { /* nothing is known of the state */
            state->v_star = R(0.0);
            state->r_star = R(0.0);
            state->v_star_slope = R(0.0);
            state->r_star_slope = R(0.0);
            state->error_offset = R(0.0);
            state->slope_offset = R(0.0);
            state->fresh = R(0.0);
        }
        const bicycle_output_error_real ratio_v_star = inv_U*state->scale_before; /* same physical state in the new scale */
        state->v_star = ratio_v_star*state->v_star;
        state->v_star_slope = ratio_v_star*state->v_star_slope;
        const bicycle_output_error_real ratio_r_star = inv_U*state->scale_before; /* same physical state in the new scale */
        state->r_star = state->r_star*ratio_r_star;
        state->r_star_slope = state->r_star_slope*ratio_r_star;
        const bicycle_output_error_real u = R(0.5)*state->last_input + R(0.5)*u_now; /* mean of the sample's two ends */
        const bicycle_output_error_real u_change = u_now - state->last_input;
        const bicycle_output_error_real h = at_U*inv_L*(sample->dt < config->dt_high ? sample->dt : R(0.0)); /* dimensionless time step */
        const bicycle_output_error_real inv0 = (R(1.0)/config->rho);
        const bicycle_output_error_real inv1 = (R(1.0)/(config->pi1 - R(1.0)));
        const bicycle_output_error_real c0 = (-state->r_star);
        const bicycle_output_error_real c1 = config->pi1*state->r_star;
        const bicycle_output_error_real c2 = config->eta*(c0 + c1 + state->v_star);
        const bicycle_output_error_real c3 = inv1*config->pi1;
        const bicycle_output_error_real c4 = u - c1 - state->v_star;
        const bicycle_output_error_real c5 = state->K*(inv_U*inv_U);
        const bicycle_output_error_real c6 = c5*(c4 + c2*c3);
        const bicycle_output_error_real c7 = c5*inv0;
        const bicycle_output_error_real c8 = c7*inv1;
        const bicycle_output_error_real c9 = c8*((-c2) - c4);
        const bicycle_output_error_real c10 = R(0.16666666666666666)*h;
        const bicycle_output_error_real c11 = config->eta - R(1.0);
        const bicycle_output_error_real f_v_star = c0 + c6; /* rate [-] */
        const bicycle_output_error_real f_r_star = c9; /* rate [-] */
        const bicycle_output_error_real J_00 = c10*c5*(c3*config->eta - R(1.0));
        const bicycle_output_error_real J_01 = c10*(c11*c5*config->pi1 - R(1.0));
        const bicycle_output_error_real J_10 = (-c10*c11*c8);
        const bicycle_output_error_real J_11 = c10*c7*(inv1*config->pi1 - config->eta);
        const bicycle_output_error_real f_v_star_K = c6;
        const bicycle_output_error_real f_r_star_K = c9;
        const bicycle_output_error_real f_v_star_u = c5;
        const bicycle_output_error_real f_r_star_u = (-c8);
        const bicycle_output_error_real p0 = J_00*J_11 - J_01*J_10;
        const bicycle_output_error_real p1 = (-J_00) - J_11;
        const bicycle_output_error_real n0 = R(1.0) - R(1.5)*p0;
        const bicycle_output_error_real n1 = (-R(2.0)) - R(1.5)*p1;
        const bicycle_output_error_real i_det = (R(1.0)/((n0*n0) + p0*(n1*n1) - n0*n1*p1)); /* det N > 0 for every real J */
        const bicycle_output_error_real i0 = i_det*(n0 - n1*p1);
        const bicycle_output_error_real i1 = (-i_det*n1);
        const bicycle_output_error_real E0 = i0 - i1*p0; /* half a step */
        const bicycle_output_error_real E1 = i0 + i1 - i1*p1;
        const bicycle_output_error_real H0 = R(0.5)*h*i0 + R(0.25)*h*i1*p0; /* change per rate over half a step */
        const bicycle_output_error_real H1 = R(0.5)*h*i1 + R(0.25)*h*i1*p1 - R(0.25)*h*i0;
        const bicycle_output_error_real m0 = (E0*E0) - p0*(E1*E1);
        const bicycle_output_error_real m1 = R(2.0)*E0*E1 - p1*(E1*E1);
        const bicycle_output_error_real g0 = H0*(R(1.0) + E0) - E1*H1*p0;
        const bicycle_output_error_real g1 = E1*H0 + H1*(R(1.0) + E0) - E1*H1*p1;
        const bicycle_output_error_real wi0 = (-p0*(R(0.4375) + R(0.1875)*p1));
        const bicycle_output_error_real wi1 = R(0.1875)*p0 - R(0.5) - p1*(R(0.4375) + R(0.1875)*p1);
        const bicycle_output_error_real wh0 = i0*wi0 - i1*p0*wi1;
        const bicycle_output_error_real wh1 = i0*wi1 + i1*wi0 - i1*p1*wi1;
        const bicycle_output_error_real w0 = i0*wh0 - i1*p0*wh1; /* W/h in powers of J */
        const bicycle_output_error_real w1 = i0*wh1 + i1*wh0 - i1*p1*wh1;
        const bicycle_output_error_real M_00 = m0 + J_00*m1; /* dx+/dx */
        const bicycle_output_error_real M_01 = J_01*m1;
        const bicycle_output_error_real M_10 = J_10*m1;
        const bicycle_output_error_real M_11 = m0 + J_11*m1;
        const bicycle_output_error_real G_00 = g0 + J_00*g1; /* change per rate */
        const bicycle_output_error_real G_01 = J_01*g1;
        const bicycle_output_error_real G_10 = J_10*g1;
        const bicycle_output_error_real G_11 = g0 + J_11*g1;
        const bicycle_output_error_real ramp = h*u_change;
        const bicycle_output_error_real ramp_0 = ramp*w0;
        const bicycle_output_error_real ramp_1 = ramp*w1;
        const bicycle_output_error_real slope1_v_star = J_00*f_v_star_u + J_01*f_r_star_u;
        const bicycle_output_error_real slope1_r_star = J_10*f_v_star_u + J_11*f_r_star_u;
        const bicycle_output_error_real rise_v_star = f_v_star_u*ramp_0 + ramp_1*slope1_v_star; /* the input rises or falls in a straight line [-] */
        const bicycle_output_error_real rise_r_star = f_r_star_u*ramp_0 + ramp_1*slope1_r_star;
        const bicycle_output_error_real d_v_star = rise_v_star + G_00*f_v_star + G_01*f_r_star; /* change over the step [-] */
        const bicycle_output_error_real d_r_star = rise_r_star + G_10*f_v_star + G_11*f_r_star; /* change over the step [-] */
        const bicycle_output_error_real F_v_star_K = G_00*f_v_star_K + G_01*f_r_star_K;
        const bicycle_output_error_real F_r_star_K = G_10*f_v_star_K + G_11*f_r_star_K;
        const bicycle_output_error_real after_v_star = d_v_star + state->v_star;
        const bicycle_output_error_real after_r_star = d_r_star + state->r_star;
        const bicycle_output_error_real after_v_star_slope = F_v_star_K + M_00*state->v_star_slope + M_01*state->r_star_slope;
        const bicycle_output_error_real after_r_star_slope = F_r_star_K + M_10*state->v_star_slope + M_11*state->r_star_slope;
        state->v_star = after_v_star;
        state->v_star_slope = after_v_star_slope;
        state->r_star = after_r_star;
        state->r_star_slope = after_r_star_slope;
        const bicycle_output_error_real output_scale = at_U*inv_L;
        const bicycle_output_error_real inv_output_scale = config->L*inv_U;
        const bicycle_output_error_real follow = usable*((R(1.0)) < (sample->dt*config->offset_rate) ? R(1.0) : sample->dt*config->offset_rate);
        const bicycle_output_error_real slope = output_scale*state->r_star_slope;
        const bicycle_output_error_real error = y_now - output_scale*state->r_star;
        state->error_offset = state->error_offset + follow*(error - state->error_offset);
        state->slope_offset = state->slope_offset + follow*(slope - state->slope_offset);
        const bicycle_output_error_real psi = slope - state->slope_offset; /* sensitivity without its slow part */
        const bicycle_output_error_real residual = error - state->error_offset; /* error without its slow part */
        innovation = (usable > R(0.5) ? residual : R(0.0));
        predicted = state->error_offset + y_now - error; /* the model and its offset */
        const bicycle_output_error_real drive = psi; /* what the input alone does to the regression */
        state->excitation = state->excitation + ((drive*drive) - state->excitation)*((R(1.0)) < (sample->dt*config->excitation_rate) ? R(1.0) : sample->dt*config->excitation_rate);
        excited = (state->excitation > config->excitation_least ? R(1.0) : R(0.0));
        const bicycle_output_error_real keep = R(1.0) - ((R(0.5)) < (sample->dt*config->forgetting_rate) ? R(0.5) : sample->dt*config->forgetting_rate);
        if ((excited > R(0.5)) && (live > 0) && (state->fresh > config->settle_samples)) { /* the input excites the unknown */
            state->A = (psi*psi) + state->A*keep;
            const bicycle_output_error_real wanted = psi*residual/state->A;
            const bicycle_output_error_real move = (((-config->move_limit)) > (((config->move_limit) < (wanted) ? config->move_limit : wanted)) ? (-config->move_limit) : ((config->move_limit) < (wanted) ? config->move_limit : wanted));
            state->K = state->K*(R(1.0) + move*(R(1.0) + move*(R(0.5) + R(0.16666666666666666)*move)));
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
                const bicycle_output_error_real counted = (state->blocks > (-R(0.5)) ? R(1.0) : R(0.0)); /* not the first */
                state->scatter_sum = counted*((state->block_score*state->block_score) + config->block_keep*state->scatter_sum);
                state->scatter_weight = counted*(state->block_weight + config->block_keep*state->scatter_weight);
                state->blocks = ((config->blocks_most) < (R(1.0) + state->blocks) ? config->blocks_most : R(1.0) + state->blocks);
                state->block_score = R(0.0);
                state->block_weight = R(0.0);
                state->block_age = R(0.0);
            }
            if ((state->blocks > R(2.5)) && (state->scatter_weight > R(0.015625)*state->A)) { /* enough blocks */
                spread = ((config->scatter_low) > (state->scatter_sum/state->scatter_weight) ? config->scatter_low : state->scatter_sum/state->scatter_weight); /* variance of the residual as felt */
                state->log_variance = ((config->variance_limit) < (spread*(R(1.0) + R(5.0)/state->blocks)/state->A) ? config->variance_limit : spread*(R(1.0) + R(5.0)/state->blocks)/state->A);
                const bicycle_output_error_real told = (psi*psi)/spread; /* by this sample */
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
        if ((excited > R(0.5)) && (live > 0) && (state->fresh > config->settle_samples)) { /* unseen, K may change */
            state->aged = state->aged*keep;
        } else {
            state->aged = ((config->variance_limit) < (state->aged + sample->dt*config->idle_drift) ? config->variance_limit : state->aged + sample->dt*config->idle_drift);
        }
        const bicycle_output_error_real damped = state->K*state->damping*inv_L*inv_U;
        const bicycle_output_error_real held = state->K*state->stiffness*(inv_L*inv_L) + state->pair_output*(state->K*state->K)*(inv_L*inv_L)*(inv_U*inv_U); /* y'' = -held y */
        const bicycle_output_error_real pull = inv_output_scale*usable*((R(1.0)) < (sample->dt*(config->observer_rate + R(4.0)*((R(0.0)) > (config->observer_margin - held) ? R(0.0) : config->observer_margin - held)/damped)) ? R(1.0) : sample->dt*(config->observer_rate + R(4.0)*((R(0.0)) > (config->observer_margin - held) ? R(0.0) : config->observer_margin - held)/damped));
        state->r_star = state->r_star + pull*residual;
        state->r_star_slope = state->r_star_slope - psi*pull;
        state->scale_before = state->last_U;
        if (usable > R(0.5)) {
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
SIMILITUDE_API int bicycle_output_error_step(const bicycle_output_error_config *config, bicycle_output_error_state *state,
                               const bicycle_output_error_sample *sample, bicycle_output_error_output *output)
{
    return bicycle_output_error_advance(config, state, sample, output);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long bicycle_output_error_batch(const bicycle_output_error_config *config, bicycle_output_error_state *state, long n,
                                 const bicycle_output_error_sample *samples, bicycle_output_error_output *outputs, int *status)
{
    bicycle_output_error_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = bicycle_output_error_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}
