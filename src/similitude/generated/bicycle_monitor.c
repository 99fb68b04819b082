/* Change alarm of the bicycle. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle, Brennan & Alleyne 2004, eqs 1-4
 *   base: m, L, U
 *   follows: K; held: K, pi1, eta, rho
 *
 * Operations: step 1156 at most, 18 at least (arithmetic, comparisons, selects), init 0.
 * Memory: state 60 reals, configuration 43 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL bicycle_monitor_real;
#define R(x) ((bicycle_monitor_real)(x))

enum bicycle_monitor_status {
    BICYCLE_MONITOR_OK = 0,
    BICYCLE_MONITOR_NOT_EXCITED = 1,
    BICYCLE_MONITOR_OUTSIDE_LINEAR = 2,
    BICYCLE_MONITOR_AT_LIMIT = 3,
    BICYCLE_MONITOR_NO_MEASUREMENT = 4,
    BICYCLE_MONITOR_RESTARTED = 5,
    BICYCLE_MONITOR_TOO_SLOW = 6,
    BICYCLE_MONITOR_BAD_SAMPLE = 7
};

typedef struct bicycle_monitor_config {
    bicycle_monitor_real L;                          /* [m] wheelbase */
    bicycle_monitor_real v_star_sd;                  /* [-] sd after a restart */
    bicycle_monitor_real r_star_sd;                  /* [-] sd after a restart */
    bicycle_monitor_real disturbance_rate;           /* [1/s] 1/correlation time of the disturbance */
    bicycle_monitor_real companion_rate;             /* [1/s] rate at which the drives along the input follow the held filter */
    bicycle_monitor_real threshold_fall;             /* [-] evidence that rings for a fall */
    bicycle_monitor_real threshold_rise;             /* [-] evidence that rings for a rise */
    bicycle_monitor_real evidence_floor;             /* [-] evidence against a change at which it is supposed to begin anew */
    bicycle_monitor_real evidence_leak;              /* [1/s] rate at which evidence is forgotten */
    bicycle_monitor_real age_most;                   /* [s] longest time one supposed change is followed */
    bicycle_monitor_real gain_rate;                  /* [1/s] averaging rate of the evidence gained */
    bicycle_monitor_real gain_most;                  /* [1/s] most evidence gained in a second */
    bicycle_monitor_real piece_most;                 /* [-] evidence from one half-wave of the signature that counts in full */
    bicycle_monitor_real piece_share;                /* [-] what counts of the rest where the change explains the drive */
    bicycle_monitor_real piece_fit;                  /* [-] most of what the reference leaves that a change may leave, for that */
    bicycle_monitor_real size_least;                 /* [-] least change of ln K that is looked for */
    bicycle_monitor_real size_most;                  /* [-] greatest change of ln K that is looked for */
    bicycle_monitor_real size_large;                 /* [-] change of ln K that needs no more evidence than the threshold */
    bicycle_monitor_real small_price;                /* [-] further evidence a smaller one needs, for each unit of the difference */
    bicycle_monitor_real size_guess;                 /* [-] change of ln K supposed at first */
    bicycle_monitor_real size_weight;                /* [-] information the first guess is worth */
    bicycle_monitor_real outlier_ratio;              /* [-] squared innovation over its variance beyond which it is bounded */
    bicycle_monitor_real smooth_rate;                /* [1/s] averaging rate of the innovations' slow part */
    bicycle_monitor_real rough_rate;                 /* [1/s] averaging rate of that part's mean square */
    bicycle_monitor_real rough_free;                 /* [-] mean square against white noise up to which evidence comes fast */
    bicycle_monitor_real rough_share;                /* [-] most of what the reference leaves that a change may leave */
    bicycle_monitor_real score_rate;                 /* [1/s] averaging rate of the score */
    bicycle_monitor_real distrust_rate;              /* [1/s] averaging rate of the squared score against its variance */
    bicycle_monitor_real distrust_share;             /* [-] how much of that is held against the evidence */
    bicycle_monitor_real sizes_squared;              /* [-] least squared size of a change over the reference's variance */
    bicycle_monitor_real reference_rate;             /* [1/s] rate at which the reference follows the estimate */
    bicycle_monitor_real known_least;                /* [-] information about ln K before the monitor is armed */
    bicycle_monitor_real variance_most;              /* [-] variance of ln K with which the monitor can be armed */
    bicycle_monitor_real heard_least;                /* [s] time of sure listening before the monitor is armed */
    bicycle_monitor_real heard_spare;                /* [s] most such time kept beyond that */
    bicycle_monitor_real heard_again;                /* [s] such time after an alarm before the next */
    bicycle_monitor_real hearing_rate;               /* [1/s] averaging rate of the information heard a second */
    bicycle_monitor_real hearing_least;              /* [1/s] information about ln K a second below which nothing is judged */
    bicycle_monitor_real input_limit;                /* [rad] greatest believable delta */
    bicycle_monitor_real output_limit;               /* [rad/s] greatest believable r */
    bicycle_monitor_real signal_limit;               /* [m/s] greatest believable scale */
    bicycle_monitor_real validity_limit;             /* [m/s^2] beyond it nothing is judged */
    bicycle_monitor_real validity_rate;              /* [1/s] decay rate of the memory of a visit beyond it */
} bicycle_monitor_config;

typedef struct bicycle_monitor_state {
    bicycle_monitor_real v_star_held;                /* [-] dynamic state of the held filter */
    bicycle_monitor_real r_star_held;                /* [-] dynamic state of the held filter */
    bicycle_monitor_real disturbance_held;           /* [rad] disturbance of the held filter */
    bicycle_monitor_real P[6];                       /* [-] covariance of the above, upper triangle by rows */
    bicycle_monitor_real v_star_plain;               /* [-] state along the steer alone */
    bicycle_monitor_real r_star_plain;               /* [-] state along the steer alone */
    bicycle_monitor_real v_star_fall;                /* [-] the same after a fall */
    bicycle_monitor_real r_star_fall;                /* [-] the same after a fall */
    bicycle_monitor_real v_star_miss_fall;           /* [-] the held filter's error after a fall */
    bicycle_monitor_real r_star_miss_fall;           /* [-] the held filter's error after a fall */
    bicycle_monitor_real disturbance_miss_fall;      /* [-] the held filter's error after a fall */
    bicycle_monitor_real v_star_rise;                /* [-] the same after a rise */
    bicycle_monitor_real r_star_rise;                /* [-] the same after a rise */
    bicycle_monitor_real v_star_miss_rise;           /* [-] the held filter's error after a rise */
    bicycle_monitor_real r_star_miss_rise;           /* [-] the held filter's error after a rise */
    bicycle_monitor_real disturbance_miss_rise;      /* [-] the held filter's error after a rise */
    bicycle_monitor_real K_held;                     /* [m^2/s^2] reference of Caf L/m, front cornering stiffness per mass and length */
    bicycle_monitor_real pi1_held;                   /* [-] reference of a/L, position of the centre of gravity */
    bicycle_monitor_real eta_held;                   /* [-] reference of rear over front cornering coefficient; > 1 understeers */
    bicycle_monitor_real rho_held;                   /* [-] reference of Iz/(m a b), yaw inertia ratio */
    bicycle_monitor_real input_offset_held;          /* [rad] reference of the offset of delta */
    bicycle_monitor_real output_bias_held;           /* [rad/s] reference of the bias of r */
    bicycle_monitor_real variance_held;              /* [-] variance that ln K has in the reference */
    bicycle_monitor_real size_fall;                  /* [-] fall: logarithm of the supposed change */
    bicycle_monitor_real evidence_fall;              /* [-] fall: log likelihood for it over the reference */
    bicycle_monitor_real age_fall;                   /* [s] fall: time since it is supposed */
    bicycle_monitor_real weight_sum_fall;            /* [-] fall: information about its size */
    bicycle_monitor_real score_sum_fall;             /* [-] fall: information times size */
    bicycle_monitor_real lately_fall;                /* [-] fall: recent mean of the evidence gained */
    bicycle_monitor_real side_fall;                  /* [rad/s] fall: signature's side of zero */
    bicycle_monitor_real piece_fall;                 /* [-] fall: evidence from this half-wave */
    bicycle_monitor_real size_rise;                  /* [-] rise: logarithm of the supposed change */
    bicycle_monitor_real evidence_rise;              /* [-] rise: log likelihood for it over the reference */
    bicycle_monitor_real age_rise;                   /* [s] rise: time since it is supposed */
    bicycle_monitor_real weight_sum_rise;            /* [-] rise: information about its size */
    bicycle_monitor_real score_sum_rise;             /* [-] rise: information times size */
    bicycle_monitor_real lately_rise;                /* [-] rise: recent mean of the evidence gained */
    bicycle_monitor_real side_rise;                  /* [rad/s] rise: signature's side of zero */
    bicycle_monitor_real piece_rise;                 /* [-] rise: evidence from this half-wave */
    bicycle_monitor_real smooth_same;                /* [rad/s] slow part of what is left, same */
    bicycle_monitor_real smooth_fall;                /* [rad/s] slow part of what is left, fall */
    bicycle_monitor_real smooth_rise;                /* [rad/s] slow part of what is left, rise */
    bicycle_monitor_real rough_same;                 /* [-] its mean square against white noise, same */
    bicycle_monitor_real rough_fall;                 /* [-] its mean square against white noise, fall */
    bicycle_monitor_real rough_rise;                 /* [-] its mean square against white noise, rise */
    bicycle_monitor_real score;                      /* [-] recent score of the reference */
    bicycle_monitor_real score_variance;             /* [-] its variance were the innovations white */
    bicycle_monitor_real distrust;                   /* [-] long-run mean of the squared score over that variance */
    bicycle_monitor_real known;                      /* [-] information about the first unknown, the others given */
    bicycle_monitor_real hearing;                    /* [1/s] the same a second */
    bicycle_monitor_real heard;                      /* [s] time of sure listening */
    bicycle_monitor_real validity;                   /* [(m/s^2)^2] recent peak, squared */
    bicycle_monitor_real last_input;                 /* [rad] input of the sample before */
    bicycle_monitor_real last_U;                     /* [m/s] forward speed of the sample before */
    bicycle_monitor_real started;                    /* [-] 1 once a sample was seen */
} bicycle_monitor_state;

typedef struct bicycle_monitor_sample {
    bicycle_monitor_real dt;                         /* [s] time since the sample before */
    bicycle_monitor_real input;                      /* [rad] road-wheel steer angle */
    bicycle_monitor_real U;                          /* [m/s] forward speed */
    bicycle_monitor_real measured;                   /* [rad/s] measured yaw rate */
    bicycle_monitor_real code;                       /* [-] status of the filter's step */
    bicycle_monitor_real estimate;                   /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_monitor_real own_variance;               /* [-] variance of ln K that the filter goes by */
    bicycle_monitor_real pi1_now;                    /* [-] a/L, position of the centre of gravity */
    bicycle_monitor_real eta_now;                    /* [-] rear over front cornering coefficient; > 1 understeers */
    bicycle_monitor_real rho_now;                    /* [-] Iz/(m a b), yaw inertia ratio */
    bicycle_monitor_real offset_now;                 /* [rad] offset of delta */
    bicycle_monitor_real bias_now;                   /* [rad/s] bias of r */
    bicycle_monitor_real noise_now;                  /* [(rad/s)^2] variance of the measurement */
    bicycle_monitor_real disturbance_now;            /* [(rad)^2] variance of the disturbance in the long run */
} bicycle_monitor_sample;

typedef struct bicycle_monitor_output {
    bicycle_monitor_real alarm;                      /* [-] 0, or 1 where a fall and 2 where a rise is found at this sample */
    bicycle_monitor_real onset_age;                  /* [s] how long ago it began */
    bicycle_monitor_real change;                     /* [-] change of ln K */
    bicycle_monitor_real change_variance;            /* [-] its variance */
    bicycle_monitor_real reference;                  /* [m^2/s^2] what K was before, as the monitor follows it */
    bicycle_monitor_real evidence_of_fall;           /* [-] log likelihood of a fall, less what its smallness costs */
    bicycle_monitor_real evidence_of_rise;           /* [-] log likelihood of a rise, less what its smallness costs */
    bicycle_monitor_real armed;                      /* [-] 1 where a change would be found now */
    bicycle_monitor_real information_rate;           /* [1/s] information about ln K a second, the others given */
} bicycle_monitor_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void bicycle_monitor_init(const bicycle_monitor_config *config, bicycle_monitor_state *state)
{
    (void)config;
    bicycle_monitor_real *const P = state->P;
    state->v_star_held = R(0.0);
    state->r_star_held = R(0.0);
    state->disturbance_held = R(0.0);
    P[0] = R(0.0);
    P[1] = R(0.0);
    P[2] = R(0.0);
    P[3] = R(0.0);
    P[4] = R(0.0);
    P[5] = R(0.0);
    state->v_star_plain = R(0.0);
    state->r_star_plain = R(0.0);
    state->v_star_fall = R(0.0);
    state->r_star_fall = R(0.0);
    state->v_star_miss_fall = R(0.0);
    state->r_star_miss_fall = R(0.0);
    state->disturbance_miss_fall = R(0.0);
    state->v_star_rise = R(0.0);
    state->r_star_rise = R(0.0);
    state->v_star_miss_rise = R(0.0);
    state->r_star_miss_rise = R(0.0);
    state->disturbance_miss_rise = R(0.0);
    state->K_held = R(0.0);
    state->pi1_held = R(0.0);
    state->eta_held = R(0.0);
    state->rho_held = R(0.0);
    state->input_offset_held = R(0.0);
    state->output_bias_held = R(0.0);
    state->variance_held = R(0.0);
    state->size_fall = R(0.0);
    state->evidence_fall = R(0.0);
    state->age_fall = R(0.0);
    state->weight_sum_fall = R(0.0);
    state->score_sum_fall = R(0.0);
    state->lately_fall = R(0.0);
    state->side_fall = R(0.0);
    state->piece_fall = R(0.0);
    state->size_rise = R(0.0);
    state->evidence_rise = R(0.0);
    state->age_rise = R(0.0);
    state->weight_sum_rise = R(0.0);
    state->score_sum_rise = R(0.0);
    state->lately_rise = R(0.0);
    state->side_rise = R(0.0);
    state->piece_rise = R(0.0);
    state->smooth_same = R(0.0);
    state->smooth_fall = R(0.0);
    state->smooth_rise = R(0.0);
    state->rough_same = R(1.0);
    state->rough_fall = R(1.0);
    state->rough_rise = R(1.0);
    state->score = R(0.0);
    state->score_variance = R(0.0);
    state->distrust = R(1.0);
    state->known = R(0.0);
    state->hearing = R(0.0);
    state->heard = R(0.0);
    state->validity = R(0.0);
    state->last_input = R(0.0);
    state->last_U = R(0.0);
    state->started = R(0.0);
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_monitor_advance(const bicycle_monitor_config *config, bicycle_monitor_state *state,
                                     const bicycle_monitor_sample *sample, bicycle_monitor_output *output)
{
    bicycle_monitor_real *const P = state->P;
    bicycle_monitor_real U_used = R(0.0);
    bicycle_monitor_real alarm = R(0.0);
    bicycle_monitor_real anew = R(0.0);
    bicycle_monitor_real armed = R(0.0);
    bicycle_monitor_real change = R(0.0);
    bicycle_monitor_real change_variance = R(0.0);
    bicycle_monitor_real evidence_of_fall = R(0.0);
    bicycle_monitor_real evidence_of_rise = R(0.0);
    bicycle_monitor_real information_rate = R(0.0);
    bicycle_monitor_real onset_age = R(0.0);
    bicycle_monitor_real reference = R(0.0);
    int status = 0;
    bicycle_monitor_real u_now = R(0.0);
    bicycle_monitor_real usable = R(0.0);

    status = 0;
    alarm = R(0.0);
    onset_age = R(0.0);
    change = R(0.0);
    change_variance = R(0.0);
    if ((sample->dt < R(1000000.0)) && (sample->dt > R(1e-06))) { /* time must advance */
        if ((sample->input < config->input_limit) && (sample->input > (-config->input_limit))) { /* missing: held */
            u_now = sample->input;
        } else {
            u_now = state->last_input;
        }
        if ((sample->U < config->signal_limit) && (sample->U > (-config->signal_limit))) { /* missing: held */
            U_used = sample->U;
        } else {
            U_used = state->last_U;
        }
        usable = ((sample->code < R(3.5)) && (sample->measured < config->output_limit) && (sample->measured > (-config->output_limit)) ? R(1.0) : R(0.0));
        anew = (((sample->code < R(5.5)) && (sample->code > R(4.5))) || ((sample->code < R(6.5)) && (sample->code > R(5.5))) || (state->started < R(0.5)) ? R(1.0) : R(0.0));
        state->started = R(1.0);
        if (anew > R(0.5)) { /* nothing is known of the dynamics */
            state->v_star_held = R(0.0);
            state->r_star_held = R(0.0);
            state->disturbance_held = R(0.0);
            state->v_star_plain = R(0.0);
            state->r_star_plain = R(0.0);
            state->v_star_fall = R(0.0);
            state->r_star_fall = R(0.0);
            state->v_star_miss_fall = R(0.0);
            state->r_star_miss_fall = R(0.0);
            state->disturbance_miss_fall = R(0.0);
            state->v_star_rise = R(0.0);
            state->r_star_rise = R(0.0);
            state->v_star_miss_rise = R(0.0);
            state->r_star_miss_rise = R(0.0);
            state->disturbance_miss_rise = R(0.0);
            P[1] = R(0.0);
            P[2] = R(0.0);
            P[4] = R(0.0);
            P[0] = (config->v_star_sd*config->v_star_sd);
            P[3] = (config->r_star_sd*config->r_star_sd);
            P[5] = sample->disturbance_now;
            state->last_input = u_now;
            state->last_U = U_used;
            state->evidence_fall = R(0.0);
            state->age_fall = R(0.0);
            state->weight_sum_fall = R(0.0);
            state->score_sum_fall = R(0.0);
            state->lately_fall = R(0.0);
            state->side_fall = R(0.0);
            state->piece_fall = R(0.0);
            state->v_star_fall = state->v_star_plain;
            state->r_star_fall = state->r_star_plain;
            state->smooth_fall = state->smooth_same;
            state->rough_fall = state->rough_same;
            state->v_star_miss_fall = R(0.0);
            state->r_star_miss_fall = R(0.0);
            state->disturbance_miss_fall = R(0.0);
            state->evidence_rise = R(0.0);
            state->age_rise = R(0.0);
            state->weight_sum_rise = R(0.0);
            state->score_sum_rise = R(0.0);
            state->lately_rise = R(0.0);
            state->side_rise = R(0.0);
            state->piece_rise = R(0.0);
            state->v_star_rise = state->v_star_plain;
            state->r_star_rise = state->r_star_plain;
            state->smooth_rise = state->smooth_same;
            state->rough_rise = state->rough_same;
            state->v_star_miss_rise = R(0.0);
            state->r_star_miss_rise = R(0.0);
            state->disturbance_miss_rise = R(0.0);
        }
        const bicycle_monitor_real follow = (!((state->heard > config->heard_least) && (state->known > config->known_least)) ? R(1.0) : ((sample->code < R(0.5)) && (sample->code > (-R(0.5))) && (state->hearing > config->hearing_least) ? ((R(1.0)) < (sample->dt*config->reference_rate) ? R(1.0) : sample->dt*config->reference_rate) : R(0.0)));
        state->K_held = state->K_held + follow*(sample->estimate - state->K_held);
        state->pi1_held = state->pi1_held + follow*(sample->pi1_now - state->pi1_held);
        state->eta_held = state->eta_held + follow*(sample->eta_now - state->eta_held);
        state->rho_held = state->rho_held + follow*(sample->rho_now - state->rho_held);
        state->input_offset_held = state->input_offset_held + follow*(sample->offset_now - state->input_offset_held);
        state->output_bias_held = state->output_bias_held + follow*(sample->bias_now - state->output_bias_held);
        state->variance_held = state->variance_held + follow*(sample->own_variance - state->variance_held);
        state->size_fall = (-((config->size_most) < (((config->size_least) > ((config->size_guess*config->size_weight - state->score_sum_fall)/(config->size_weight + state->weight_sum_fall)) ? config->size_least : (config->size_guess*config->size_weight - state->score_sum_fall)/(config->size_weight + state->weight_sum_fall))) ? config->size_most : ((config->size_least) > ((config->size_guess*config->size_weight - state->score_sum_fall)/(config->size_weight + state->weight_sum_fall)) ? config->size_least : (config->size_guess*config->size_weight - state->score_sum_fall)/(config->size_weight + state->weight_sum_fall))));
        const bicycle_monitor_real K_fall = state->K_held*(R(12.0) + state->size_fall*(R(6.0) + state->size_fall))/((R(12.0) + state->size_fall*(state->size_fall - R(6.0)))); /* exp by its Pade approximant, good to 0.1 % for a fall by a factor of three */
        state->size_rise = ((config->size_most) < (((config->size_least) > ((state->score_sum_rise + config->size_guess*config->size_weight)/(config->size_weight + state->weight_sum_rise)) ? config->size_least : (state->score_sum_rise + config->size_guess*config->size_weight)/(config->size_weight + state->weight_sum_rise))) ? config->size_most : ((config->size_least) > ((state->score_sum_rise + config->size_guess*config->size_weight)/(config->size_weight + state->weight_sum_rise)) ? config->size_least : (state->score_sum_rise + config->size_guess*config->size_weight)/(config->size_weight + state->weight_sum_rise)));
        const bicycle_monitor_real K_rise = state->K_held*(R(12.0) + state->size_rise*(R(6.0) + state->size_rise))/((R(12.0) + state->size_rise*(state->size_rise - R(6.0)))); /* exp by its Pade approximant, good to 0.1 % for a rise by a factor of three */
        const bicycle_monitor_real least_scale = R(0.0003333333333333333)*config->signal_limit;
        const bicycle_monitor_real at_U = ((U_used) > (least_scale) ? U_used : least_scale); /* kept off zero */
        const bicycle_monitor_real was_U = ((state->last_U) > (least_scale) ? state->last_U : least_scale);
        const bicycle_monitor_real inv_U = (R(1.0)/at_U);
        const bicycle_monitor_real inv_L = (R(1.0)/config->L);
        const bicycle_monitor_real output_scale = at_U*inv_L;
        const bicycle_monitor_real h = at_U*inv_L*((R(1.0)) < (sample->dt) ? R(1.0) : sample->dt); /* dimensionless step */
        const bicycle_monitor_real steer = R(0.5)*state->last_input + R(0.5)*u_now; /* mean of the sample's two ends */
        const bicycle_monitor_real steer_change = u_now - state->last_input;
        const bicycle_monitor_real keep_w = ((R(0.0)) > (R(1.0) - config->disturbance_rate*sample->dt) ? R(0.0) : R(1.0) - config->disturbance_rate*sample->dt);
        const bicycle_monitor_real ratio_v_star = inv_U*was_U; /* same physical state in the new scales */
        const bicycle_monitor_real ratio_r_star = inv_U*was_U; /* same physical state in the new scales */
        state->v_star_held = ratio_v_star*state->v_star_held;
        state->r_star_held = state->r_star_held*ratio_r_star;
        state->v_star_plain = ratio_v_star*state->v_star_plain;
        state->r_star_plain = state->r_star_plain*ratio_r_star;
        state->v_star_fall = ratio_v_star*state->v_star_fall;
        state->r_star_fall = state->r_star_fall*ratio_r_star;
        state->v_star_rise = ratio_v_star*state->v_star_rise;
        state->r_star_rise = state->r_star_rise*ratio_r_star;
        state->v_star_miss_fall = ratio_v_star*state->v_star_miss_fall;
        state->r_star_miss_fall = state->r_star_miss_fall*ratio_r_star;
        state->v_star_miss_rise = ratio_v_star*state->v_star_miss_rise;
        state->r_star_miss_rise = state->r_star_miss_rise*ratio_r_star;
        const bicycle_monitor_real u_plain = state->input_offset_held + steer; /* the steer alone [-] */
        const bicycle_monitor_real u_held = state->disturbance_held + u_plain;
        const bicycle_monitor_real inv0 = (R(1.0)/state->rho_held);
        const bicycle_monitor_real inv1 = (R(1.0)/(state->pi1_held - R(1.0)));
        const bicycle_monitor_real c0 = (-state->r_star_held);
        const bicycle_monitor_real c1 = state->pi1_held*state->r_star_held;
        const bicycle_monitor_real c2 = state->eta_held*(c0 + c1 + state->v_star_held);
        const bicycle_monitor_real c3 = inv1*state->pi1_held;
        const bicycle_monitor_real c4 = u_held - c1 - state->v_star_held;
        const bicycle_monitor_real c5 = state->K_held*(inv_U*inv_U);
        const bicycle_monitor_real c6 = c5*inv0;
        const bicycle_monitor_real c7 = c6*inv1;
        const bicycle_monitor_real c8 = (-state->r_star_plain);
        const bicycle_monitor_real c9 = state->pi1_held*state->r_star_plain;
        const bicycle_monitor_real c10 = state->eta_held*(c8 + c9 + state->v_star_plain);
        const bicycle_monitor_real c11 = u_plain - c9 - state->v_star_plain;
        const bicycle_monitor_real c12 = R(0.16666666666666666)*h;
        const bicycle_monitor_real c13 = state->eta_held - R(1.0);
        const bicycle_monitor_real f_v_star_held = c0 + c5*(c4 + c2*c3); /* rate [-] */
        const bicycle_monitor_real f_r_star_held = c7*((-c2) - c4); /* rate [-] */
        const bicycle_monitor_real f_v_star_plain = c8 + c5*(c11 + c10*c3);
        const bicycle_monitor_real f_r_star_plain = c7*((-c10) - c11);
        const bicycle_monitor_real J_00 = c12*c5*(c3*state->eta_held - R(1.0));
        const bicycle_monitor_real J_01 = c12*(c13*c5*state->pi1_held - R(1.0));
        const bicycle_monitor_real J_10 = (-c12*c13*c7);
        const bicycle_monitor_real J_11 = c12*c6*(inv1*state->pi1_held - state->eta_held);
        const bicycle_monitor_real f_v_star_held_u_held = c5;
        const bicycle_monitor_real f_r_star_held_u_held = (-c7);
        const bicycle_monitor_real p0 = J_00*J_11 - J_01*J_10;
        const bicycle_monitor_real p1 = (-J_00) - J_11;
        const bicycle_monitor_real n0 = R(1.0) - R(1.5)*p0;
        const bicycle_monitor_real n1 = (-R(2.0)) - R(1.5)*p1;
        const bicycle_monitor_real i_det = (R(1.0)/((n0*n0) + p0*(n1*n1) - n0*n1*p1)); /* det N > 0 for every real J */
        const bicycle_monitor_real i0 = i_det*(n0 - n1*p1);
        const bicycle_monitor_real i1 = (-i_det*n1);
        const bicycle_monitor_real E0 = i0 - i1*p0; /* half a step */
        const bicycle_monitor_real E1 = i0 + i1 - i1*p1;
        const bicycle_monitor_real H0 = R(0.5)*h*i0 + R(0.25)*h*i1*p0; /* change per rate over half a step */
        const bicycle_monitor_real H1 = R(0.5)*h*i1 + R(0.25)*h*i1*p1 - R(0.25)*h*i0;
        const bicycle_monitor_real m0 = (E0*E0) - p0*(E1*E1);
        const bicycle_monitor_real m1 = R(2.0)*E0*E1 - p1*(E1*E1);
        const bicycle_monitor_real g0 = H0*(R(1.0) + E0) - E1*H1*p0;
        const bicycle_monitor_real g1 = E1*H0 + H1*(R(1.0) + E0) - E1*H1*p1;
        const bicycle_monitor_real wi0 = (-p0*(R(0.4375) + R(0.1875)*p1));
        const bicycle_monitor_real wi1 = R(0.1875)*p0 - R(0.5) - p1*(R(0.4375) + R(0.1875)*p1);
        const bicycle_monitor_real wh0 = i0*wi0 - i1*p0*wi1;
        const bicycle_monitor_real wh1 = i0*wi1 + i1*wi0 - i1*p1*wi1;
        const bicycle_monitor_real w0 = i0*wh0 - i1*p0*wh1; /* W/h in powers of J */
        const bicycle_monitor_real w1 = i0*wh1 + i1*wh0 - i1*p1*wh1;
        const bicycle_monitor_real M_00 = m0 + J_00*m1; /* dx+/dx */
        const bicycle_monitor_real M_01 = J_01*m1;
        const bicycle_monitor_real M_10 = J_10*m1;
        const bicycle_monitor_real M_11 = m0 + J_11*m1;
        const bicycle_monitor_real G_00 = g0 + J_00*g1; /* change per rate */
        const bicycle_monitor_real G_01 = J_01*g1;
        const bicycle_monitor_real G_10 = J_10*g1;
        const bicycle_monitor_real G_11 = g0 + J_11*g1;
        const bicycle_monitor_real ramp = h*steer_change;
        const bicycle_monitor_real ramp_0 = ramp*w0;
        const bicycle_monitor_real ramp_1 = ramp*w1;
        const bicycle_monitor_real slope1_v_star_held = J_00*f_v_star_held_u_held + J_01*f_r_star_held_u_held;
        const bicycle_monitor_real slope1_r_star_held = J_10*f_v_star_held_u_held + J_11*f_r_star_held_u_held;
        const bicycle_monitor_real rise_v_star_held = f_v_star_held_u_held*ramp_0 + ramp_1*slope1_v_star_held; /* the input rises or falls in a straight line [-] */
        const bicycle_monitor_real rise_r_star_held = f_r_star_held_u_held*ramp_0 + ramp_1*slope1_r_star_held;
        const bicycle_monitor_real d_v_star_held = rise_v_star_held + G_00*f_v_star_held + G_01*f_r_star_held; /* change over the step [-] */
        const bicycle_monitor_real d_r_star_held = rise_r_star_held + G_10*f_v_star_held + G_11*f_r_star_held; /* change over the step [-] */
        const bicycle_monitor_real d_v_star_plain = rise_v_star_held + G_00*f_v_star_plain + G_01*f_r_star_plain;
        const bicycle_monitor_real d_r_star_plain = rise_r_star_held + G_10*f_v_star_plain + G_11*f_r_star_plain;
        const bicycle_monitor_real F_v_star_held_u_held = G_00*f_v_star_held_u_held + G_01*f_r_star_held_u_held;
        const bicycle_monitor_real F_r_star_held_u_held = G_10*f_v_star_held_u_held + G_11*f_r_star_held_u_held;
        const bicycle_monitor_real PW_0 = P[2];
        const bicycle_monitor_real FP_0_0 = F_v_star_held_u_held*PW_0 + M_00*P[0]*ratio_v_star + M_01*P[1]*ratio_r_star;
        const bicycle_monitor_real FP_1_0 = F_r_star_held_u_held*PW_0 + M_10*P[0]*ratio_v_star + M_11*P[1]*ratio_r_star;
        const bicycle_monitor_real PW_1 = P[4];
        const bicycle_monitor_real FP_0_1 = F_v_star_held_u_held*PW_1 + M_00*P[1]*ratio_v_star + M_01*P[3]*ratio_r_star;
        const bicycle_monitor_real FP_1_1 = F_r_star_held_u_held*PW_1 + M_10*P[1]*ratio_v_star + M_11*P[3]*ratio_r_star;
        P[0] = FP_0_0*M_00*ratio_v_star + FP_0_1*M_01*ratio_r_star;
        P[1] = FP_0_0*M_10*ratio_v_star + FP_0_1*M_11*ratio_r_star;
        P[3] = FP_1_0*M_10*ratio_v_star + FP_1_1*M_11*ratio_r_star;
        const bicycle_monitor_real PW_2 = P[5];
        const bicycle_monitor_real FP_0_2 = F_v_star_held_u_held*PW_2 + M_00*P[2]*ratio_v_star + M_01*P[4]*ratio_r_star;
        const bicycle_monitor_real FP_1_2 = F_r_star_held_u_held*PW_2 + M_10*P[2]*ratio_v_star + M_11*P[4]*ratio_r_star;
        P[2] = FP_0_2*keep_w;
        P[4] = FP_1_2*keep_w;
        const bicycle_monitor_real WPF_0 = FP_0_2;
        const bicycle_monitor_real WPF_1 = FP_1_2;
        P[0] = P[0] + F_v_star_held_u_held*WPF_0;
        P[1] = P[1] + F_r_star_held_u_held*WPF_0;
        P[3] = P[3] + F_r_star_held_u_held*WPF_1;
        P[5] = P[5]*(keep_w*keep_w) + sample->disturbance_now*(R(1.0) - (keep_w*keep_w));
        state->v_star_held = d_v_star_held + state->v_star_held;
        state->r_star_held = d_r_star_held + state->r_star_held;
        state->v_star_plain = d_v_star_plain + state->v_star_plain;
        state->r_star_plain = d_r_star_plain + state->r_star_plain;
        state->disturbance_held = state->disturbance_held*keep_w;
        const bicycle_monitor_real new0_fall = F_v_star_held_u_held*state->disturbance_miss_fall + M_00*state->v_star_miss_fall + M_01*state->r_star_miss_fall;
        const bicycle_monitor_real new1_fall = F_r_star_held_u_held*state->disturbance_miss_fall + M_10*state->v_star_miss_fall + M_11*state->r_star_miss_fall;
        state->v_star_miss_fall = new0_fall;
        state->r_star_miss_fall = new1_fall;
        state->disturbance_miss_fall = state->disturbance_miss_fall*keep_w;
        const bicycle_monitor_real new0_rise = F_v_star_held_u_held*state->disturbance_miss_rise + M_00*state->v_star_miss_rise + M_01*state->r_star_miss_rise;
        const bicycle_monitor_real new1_rise = F_r_star_held_u_held*state->disturbance_miss_rise + M_10*state->v_star_miss_rise + M_11*state->r_star_miss_rise;
        state->v_star_miss_rise = new0_rise;
        state->r_star_miss_rise = new1_rise;
        state->disturbance_miss_rise = state->disturbance_miss_rise*keep_w;
        const bicycle_monitor_real inv0_fall = (R(1.0)/state->rho_held);
        const bicycle_monitor_real inv1_fall = (R(1.0)/(state->pi1_held - R(1.0)));
        const bicycle_monitor_real c0_fall = (-state->r_star_fall);
        const bicycle_monitor_real c1_fall = state->pi1_held*state->r_star_fall;
        const bicycle_monitor_real c2_fall = state->eta_held*(c0_fall + c1_fall + state->v_star_fall);
        const bicycle_monitor_real c3_fall = inv1_fall*state->pi1_held;
        const bicycle_monitor_real c4_fall = u_plain - c1_fall - state->v_star_fall;
        const bicycle_monitor_real c5_fall = K_fall*(inv_U*inv_U);
        const bicycle_monitor_real c6_fall = c5_fall*inv0_fall;
        const bicycle_monitor_real c7_fall = c6_fall*inv1_fall;
        const bicycle_monitor_real c8_fall = R(0.16666666666666666)*h;
        const bicycle_monitor_real c9_fall = state->eta_held - R(1.0);
        const bicycle_monitor_real f_v_star_fall_fall = c0_fall + c5_fall*(c4_fall + c2_fall*c3_fall); /* rate [-] */
        const bicycle_monitor_real f_r_star_fall_fall = c7_fall*((-c2_fall) - c4_fall); /* rate [-] */
        const bicycle_monitor_real J_00_fall = c5_fall*c8_fall*(c3_fall*state->eta_held - R(1.0));
        const bicycle_monitor_real J_01_fall = c8_fall*(c5_fall*c9_fall*state->pi1_held - R(1.0));
        const bicycle_monitor_real J_10_fall = (-c7_fall*c8_fall*c9_fall);
        const bicycle_monitor_real J_11_fall = c6_fall*c8_fall*(inv1_fall*state->pi1_held - state->eta_held);
        const bicycle_monitor_real f_v_star_fall_u_plain_fall = c5_fall;
        const bicycle_monitor_real f_r_star_fall_u_plain_fall = (-c7_fall);
        const bicycle_monitor_real p0_fall = J_00_fall*J_11_fall - J_01_fall*J_10_fall;
        const bicycle_monitor_real p1_fall = (-J_00_fall) - J_11_fall;
        const bicycle_monitor_real n0_fall = R(1.0) - R(1.5)*p0_fall;
        const bicycle_monitor_real n1_fall = (-R(2.0)) - R(1.5)*p1_fall;
        const bicycle_monitor_real i_det_fall = (R(1.0)/((n0_fall*n0_fall) + p0_fall*(n1_fall*n1_fall) - n0_fall*n1_fall*p1_fall)); /* det N > 0 for every real J */
        const bicycle_monitor_real i0_fall = i_det_fall*(n0_fall - n1_fall*p1_fall);
        const bicycle_monitor_real i1_fall = (-i_det_fall*n1_fall);
        const bicycle_monitor_real E0_fall = i0_fall - i1_fall*p0_fall; /* half a step */
        const bicycle_monitor_real E1_fall = i0_fall + i1_fall - i1_fall*p1_fall;
        const bicycle_monitor_real H0_fall = R(0.5)*h*i0_fall + R(0.25)*h*i1_fall*p0_fall; /* change per rate over half a step */
        const bicycle_monitor_real H1_fall = R(0.5)*h*i1_fall + R(0.25)*h*i1_fall*p1_fall - R(0.25)*h*i0_fall;
        const bicycle_monitor_real g0_fall = H0_fall*(R(1.0) + E0_fall) - E1_fall*H1_fall*p0_fall;
        const bicycle_monitor_real g1_fall = E1_fall*H0_fall + H1_fall*(R(1.0) + E0_fall) - E1_fall*H1_fall*p1_fall;
        const bicycle_monitor_real wi0_fall = (-p0_fall*(R(0.4375) + R(0.1875)*p1_fall));
        const bicycle_monitor_real wi1_fall = R(0.1875)*p0_fall - R(0.5) - p1_fall*(R(0.4375) + R(0.1875)*p1_fall);
        const bicycle_monitor_real wh0_fall = i0_fall*wi0_fall - i1_fall*p0_fall*wi1_fall;
        const bicycle_monitor_real wh1_fall = i0_fall*wi1_fall + i1_fall*wi0_fall - i1_fall*p1_fall*wi1_fall;
        const bicycle_monitor_real w0_fall = i0_fall*wh0_fall - i1_fall*p0_fall*wh1_fall; /* W/h in powers of J */
        const bicycle_monitor_real w1_fall = i0_fall*wh1_fall + i1_fall*wh0_fall - i1_fall*p1_fall*wh1_fall;
        const bicycle_monitor_real G_00_fall = g0_fall + J_00_fall*g1_fall; /* change per rate */
        const bicycle_monitor_real G_01_fall = J_01_fall*g1_fall;
        const bicycle_monitor_real G_10_fall = J_10_fall*g1_fall;
        const bicycle_monitor_real G_11_fall = g0_fall + J_11_fall*g1_fall;
        const bicycle_monitor_real ramp_fall = h*steer_change;
        const bicycle_monitor_real ramp_0_fall = ramp_fall*w0_fall;
        const bicycle_monitor_real ramp_1_fall = ramp_fall*w1_fall;
        const bicycle_monitor_real slope1_v_star_fall_fall = J_00_fall*f_v_star_fall_u_plain_fall + J_01_fall*f_r_star_fall_u_plain_fall;
        const bicycle_monitor_real slope1_r_star_fall_fall = J_10_fall*f_v_star_fall_u_plain_fall + J_11_fall*f_r_star_fall_u_plain_fall;
        const bicycle_monitor_real rise_v_star_fall_fall = f_v_star_fall_u_plain_fall*ramp_0_fall + ramp_1_fall*slope1_v_star_fall_fall; /* the input rises or falls in a straight line [-] */
        const bicycle_monitor_real rise_r_star_fall_fall = f_r_star_fall_u_plain_fall*ramp_0_fall + ramp_1_fall*slope1_r_star_fall_fall;
        const bicycle_monitor_real d_v_star_fall_fall = rise_v_star_fall_fall + G_00_fall*f_v_star_fall_fall + G_01_fall*f_r_star_fall_fall; /* change over the step [-] */
        const bicycle_monitor_real d_r_star_fall_fall = rise_r_star_fall_fall + G_10_fall*f_v_star_fall_fall + G_11_fall*f_r_star_fall_fall; /* change over the step [-] */
        state->v_star_fall = d_v_star_fall_fall + state->v_star_fall;
        state->r_star_fall = d_r_star_fall_fall + state->r_star_fall;
        const bicycle_monitor_real inv0_rise = (R(1.0)/state->rho_held);
        const bicycle_monitor_real inv1_rise = (R(1.0)/(state->pi1_held - R(1.0)));
        const bicycle_monitor_real c0_rise = (-state->r_star_rise);
        const bicycle_monitor_real c1_rise = state->pi1_held*state->r_star_rise;
        const bicycle_monitor_real c2_rise = state->eta_held*(c0_rise + c1_rise + state->v_star_rise);
        const bicycle_monitor_real c3_rise = inv1_rise*state->pi1_held;
        const bicycle_monitor_real c4_rise = u_plain - c1_rise - state->v_star_rise;
        const bicycle_monitor_real c5_rise = K_rise*(inv_U*inv_U);
        const bicycle_monitor_real c6_rise = c5_rise*inv0_rise;
        const bicycle_monitor_real c7_rise = c6_rise*inv1_rise;
        const bicycle_monitor_real c8_rise = R(0.16666666666666666)*h;
        const bicycle_monitor_real c9_rise = state->eta_held - R(1.0);
        const bicycle_monitor_real f_v_star_rise_rise = c0_rise + c5_rise*(c4_rise + c2_rise*c3_rise); /* rate [-] */
        const bicycle_monitor_real f_r_star_rise_rise = c7_rise*((-c2_rise) - c4_rise); /* rate [-] */
        const bicycle_monitor_real J_00_rise = c5_rise*c8_rise*(c3_rise*state->eta_held - R(1.0));
        const bicycle_monitor_real J_01_rise = c8_rise*(c5_rise*c9_rise*state->pi1_held - R(1.0));
        const bicycle_monitor_real J_10_rise = (-c7_rise*c8_rise*c9_rise);
        const bicycle_monitor_real J_11_rise = c6_rise*c8_rise*(inv1_rise*state->pi1_held - state->eta_held);
        const bicycle_monitor_real f_v_star_rise_u_plain_rise = c5_rise;
        const bicycle_monitor_real f_r_star_rise_u_plain_rise = (-c7_rise);
        const bicycle_monitor_real p0_rise = J_00_rise*J_11_rise - J_01_rise*J_10_rise;
        const bicycle_monitor_real p1_rise = (-J_00_rise) - J_11_rise;
        const bicycle_monitor_real n0_rise = R(1.0) - R(1.5)*p0_rise;
        const bicycle_monitor_real n1_rise = (-R(2.0)) - R(1.5)*p1_rise;
        const bicycle_monitor_real i_det_rise = (R(1.0)/((n0_rise*n0_rise) + p0_rise*(n1_rise*n1_rise) - n0_rise*n1_rise*p1_rise)); /* det N > 0 for every real J */
        const bicycle_monitor_real i0_rise = i_det_rise*(n0_rise - n1_rise*p1_rise);
        const bicycle_monitor_real i1_rise = (-i_det_rise*n1_rise);
        const bicycle_monitor_real E0_rise = i0_rise - i1_rise*p0_rise; /* half a step */
        const bicycle_monitor_real E1_rise = i0_rise + i1_rise - i1_rise*p1_rise;
        const bicycle_monitor_real H0_rise = R(0.5)*h*i0_rise + R(0.25)*h*i1_rise*p0_rise; /* change per rate over half a step */
        const bicycle_monitor_real H1_rise = R(0.5)*h*i1_rise + R(0.25)*h*i1_rise*p1_rise - R(0.25)*h*i0_rise;
        const bicycle_monitor_real g0_rise = H0_rise*(R(1.0) + E0_rise) - E1_rise*H1_rise*p0_rise;
        const bicycle_monitor_real g1_rise = E1_rise*H0_rise + H1_rise*(R(1.0) + E0_rise) - E1_rise*H1_rise*p1_rise;
        const bicycle_monitor_real wi0_rise = (-p0_rise*(R(0.4375) + R(0.1875)*p1_rise));
        const bicycle_monitor_real wi1_rise = R(0.1875)*p0_rise - R(0.5) - p1_rise*(R(0.4375) + R(0.1875)*p1_rise);
        const bicycle_monitor_real wh0_rise = i0_rise*wi0_rise - i1_rise*p0_rise*wi1_rise;
        const bicycle_monitor_real wh1_rise = i0_rise*wi1_rise + i1_rise*wi0_rise - i1_rise*p1_rise*wi1_rise;
        const bicycle_monitor_real w0_rise = i0_rise*wh0_rise - i1_rise*p0_rise*wh1_rise; /* W/h in powers of J */
        const bicycle_monitor_real w1_rise = i0_rise*wh1_rise + i1_rise*wh0_rise - i1_rise*p1_rise*wh1_rise;
        const bicycle_monitor_real G_00_rise = g0_rise + J_00_rise*g1_rise; /* change per rate */
        const bicycle_monitor_real G_01_rise = J_01_rise*g1_rise;
        const bicycle_monitor_real G_10_rise = J_10_rise*g1_rise;
        const bicycle_monitor_real G_11_rise = g0_rise + J_11_rise*g1_rise;
        const bicycle_monitor_real ramp_rise = h*steer_change;
        const bicycle_monitor_real ramp_0_rise = ramp_rise*w0_rise;
        const bicycle_monitor_real ramp_1_rise = ramp_rise*w1_rise;
        const bicycle_monitor_real slope1_v_star_rise_rise = J_00_rise*f_v_star_rise_u_plain_rise + J_01_rise*f_r_star_rise_u_plain_rise;
        const bicycle_monitor_real slope1_r_star_rise_rise = J_10_rise*f_v_star_rise_u_plain_rise + J_11_rise*f_r_star_rise_u_plain_rise;
        const bicycle_monitor_real rise_v_star_rise_rise = f_v_star_rise_u_plain_rise*ramp_0_rise + ramp_1_rise*slope1_v_star_rise_rise; /* the input rises or falls in a straight line [-] */
        const bicycle_monitor_real rise_r_star_rise_rise = f_r_star_rise_u_plain_rise*ramp_0_rise + ramp_1_rise*slope1_r_star_rise_rise;
        const bicycle_monitor_real d_v_star_rise_rise = rise_v_star_rise_rise + G_00_rise*f_v_star_rise_rise + G_01_rise*f_r_star_rise_rise; /* change over the step [-] */
        const bicycle_monitor_real d_r_star_rise_rise = rise_r_star_rise_rise + G_10_rise*f_v_star_rise_rise + G_11_rise*f_r_star_rise_rise; /* change over the step [-] */
        state->v_star_rise = d_v_star_rise_rise + state->v_star_rise;
        state->r_star_rise = d_r_star_rise_rise + state->r_star_rise;
        const bicycle_monitor_real lean = ((R(1.0)) < (config->companion_rate*sample->dt) ? R(1.0) : config->companion_rate*sample->dt);
        state->v_star_plain = state->v_star_plain + lean*(state->v_star_held - state->v_star_plain);
        state->r_star_plain = state->r_star_plain + lean*(state->r_star_held - state->r_star_plain);
        state->v_star_fall = state->v_star_fall + lean*(state->v_star_held - state->v_star_fall);
        state->r_star_fall = state->r_star_fall + lean*(state->r_star_held - state->r_star_fall);
        state->v_star_rise = state->v_star_rise + lean*(state->v_star_held - state->v_star_rise);
        state->r_star_rise = state->r_star_rise + lean*(state->r_star_held - state->r_star_rise);
        const bicycle_monitor_real validity_now = inv_L*state->r_star_held*(at_U*at_U); /* lateral acceleration */
        const bicycle_monitor_real validity_then = state->validity*(R(1.0) - ((R(1.0)) < (sample->dt*config->validity_rate) ? R(1.0) : sample->dt*config->validity_rate));
        state->validity = (((validity_now*validity_now)) > (validity_then) ? (validity_now*validity_now) : validity_then);
        if (usable > R(0.5)) { /* measurement */
            const bicycle_monitor_real c_0 = P[1]*output_scale;
            const bicycle_monitor_real c_1 = P[3]*output_scale;
            const bicycle_monitor_real c_2 = P[4]*output_scale;
            const bicycle_monitor_real innovation = sample->measured - state->output_bias_held - output_scale*state->r_star_held;
            const bicycle_monitor_real spread = sample->noise_now + c_1*output_scale;
            const bicycle_monitor_real inv_spread = (R(1.0)/spread);
            const bicycle_monitor_real signature_fall = output_scale*state->r_star_fall - output_scale*state->r_star_miss_fall - output_scale*state->r_star_plain; /* what would be missed after a fall */
            const bicycle_monitor_real signature_rise = output_scale*state->r_star_rise - output_scale*state->r_star_miss_rise - output_scale*state->r_star_plain; /* what would be missed after a rise */
            const bicycle_monitor_real rest_same = innovation;
            const bicycle_monitor_real rest_fall = innovation - signature_fall;
            const bicycle_monitor_real rest_rise = innovation - signature_rise;
            const bicycle_monitor_real rest_least = inv_spread*(((((rest_fall*rest_fall)) < ((rest_rise*rest_rise)) ? (rest_fall*rest_fall) : (rest_rise*rest_rise))) < ((rest_same*rest_same)) ? (((rest_fall*rest_fall)) < ((rest_rise*rest_rise)) ? (rest_fall*rest_fall) : (rest_rise*rest_rise)) : (rest_same*rest_same));
            const bicycle_monitor_real weight = (config->outlier_ratio < rest_least ? config->outlier_ratio/rest_least : R(1.0)); /* what no hypothesis explains counts for less */
            const bicycle_monitor_real gain_0 = c_0*inv_spread*weight;
            const bicycle_monitor_real gain_1 = c_1*inv_spread*weight;
            const bicycle_monitor_real gain_2 = c_2*inv_spread*weight;
            P[0] = P[0] - c_0*gain_0;
            P[1] = P[1] - c_1*gain_0;
            P[2] = P[2] - c_2*gain_0;
            P[3] = P[3] - c_1*gain_1;
            P[4] = P[4] - c_2*gain_1;
            P[5] = P[5] - c_2*gain_2;
            state->v_star_held = state->v_star_held + gain_0*innovation;
            state->r_star_held = state->r_star_held + gain_1*innovation;
            state->disturbance_held = state->disturbance_held + gain_2*innovation;
            state->v_star_miss_fall = state->v_star_miss_fall + gain_0*signature_fall;
            state->r_star_miss_fall = state->r_star_miss_fall + gain_1*signature_fall;
            state->disturbance_miss_fall = state->disturbance_miss_fall + gain_2*signature_fall;
            state->v_star_miss_rise = state->v_star_miss_rise + gain_0*signature_rise;
            state->r_star_miss_rise = state->r_star_miss_rise + gain_1*signature_rise;
            state->disturbance_miss_rise = state->disturbance_miss_rise + gain_2*signature_rise;
            const bicycle_monitor_real smooth_share = ((R(1.0)) < (sample->dt*config->smooth_rate) ? R(1.0) : sample->dt*config->smooth_rate);
            const bicycle_monitor_real inv_white = inv_spread*(R(2.0) - smooth_share)/smooth_share; /* 1/variance of the average of white noise */
            state->smooth_same = state->smooth_same + smooth_share*(rest_same - state->smooth_same);
            state->rough_same = state->rough_same + (inv_white*(state->smooth_same*state->smooth_same) - state->rough_same)*((R(1.0)) < (sample->dt*config->rough_rate) ? R(1.0) : sample->dt*config->rough_rate);
            state->smooth_fall = state->smooth_fall + smooth_share*(rest_fall - state->smooth_fall);
            state->rough_fall = state->rough_fall + (inv_white*(state->smooth_fall*state->smooth_fall) - state->rough_fall)*((R(1.0)) < (sample->dt*config->rough_rate) ? R(1.0) : sample->dt*config->rough_rate);
            state->smooth_rise = state->smooth_rise + smooth_share*(rest_rise - state->smooth_rise);
            state->rough_rise = state->rough_rise + (inv_white*(state->smooth_rise*state->smooth_rise) - state->rough_rise)*((R(1.0)) < (sample->dt*config->rough_rate) ? R(1.0) : sample->dt*config->rough_rate);
            const bicycle_monitor_real rough = ((R(1.0)) > (((((state->rough_fall) < (state->rough_rise) ? state->rough_fall : state->rough_rise)) < (state->rough_same) ? ((state->rough_fall) < (state->rough_rise) ? state->rough_fall : state->rough_rise) : state->rough_same)) ? R(1.0) : ((((state->rough_fall) < (state->rough_rise) ? state->rough_fall : state->rough_rise)) < (state->rough_same) ? ((state->rough_fall) < (state->rough_rise) ? state->rough_fall : state->rough_rise) : state->rough_same));
            const bicycle_monitor_real slope = R(0.5)*signature_fall/state->size_fall + R(0.5)*signature_rise/state->size_rise;
            const bicycle_monitor_real fresh = inv_spread*(slope*slope); /* information */
            state->known = fresh + state->known;
            state->hearing = state->hearing + (fresh/sample->dt - state->hearing)*((R(1.0)) < (sample->dt*config->hearing_rate) ? R(1.0) : sample->dt*config->hearing_rate);
            state->heard = ((R(0.0)) > (((state->heard + (sample->own_variance > config->variance_most ? (-sample->dt) : ((sample->code < R(0.5)) && (state->hearing > config->hearing_least) ? sample->dt : R(0.0)))) < (config->heard_least + config->heard_spare) ? state->heard + (sample->own_variance > config->variance_most ? (-sample->dt) : ((sample->code < R(0.5)) && (state->hearing > config->hearing_least) ? sample->dt : R(0.0))) : config->heard_least + config->heard_spare)) ? R(0.0) : ((state->heard + (sample->own_variance > config->variance_most ? (-sample->dt) : ((sample->code < R(0.5)) && (state->hearing > config->hearing_least) ? sample->dt : R(0.0)))) < (config->heard_least + config->heard_spare) ? state->heard + (sample->own_variance > config->variance_most ? (-sample->dt) : ((sample->code < R(0.5)) && (state->hearing > config->hearing_least) ? sample->dt : R(0.0))) : config->heard_least + config->heard_spare));
            const bicycle_monitor_real score_keep = R(1.0) - ((R(1.0)) < (sample->dt*config->score_rate) ? R(1.0) : sample->dt*config->score_rate);
            state->score = state->score*score_keep + innovation*inv_spread*slope;
            state->score_variance = fresh + state->score_variance*(score_keep*score_keep);
            state->distrust = state->distrust + (((R(16.0)) < ((state->score*state->score)/(R(1e-09) + state->score_variance)) ? R(16.0) : (state->score*state->score)/(R(1e-09) + state->score_variance)) - state->distrust)*((R(1.0)) < (config->distrust_rate*sample->dt) ? R(1.0) : config->distrust_rate*sample->dt);
            const bicycle_monitor_real doubt = rough*((R(1.0)) > (R(1.0) + config->distrust_share*(state->distrust - R(1.0))) ? R(1.0) : R(1.0) + config->distrust_share*(state->distrust - R(1.0)));
            const bicycle_monitor_real trust = weight/doubt;
            const bicycle_monitor_real gain_bound = sample->dt*config->gain_most/((R(1.0)) > (rough/config->rough_free) ? R(1.0) : rough/config->rough_free);
            if ((state->heard > config->heard_least) && (state->hearing > config->hearing_least) && (state->known > config->known_least) && (state->validity < (config->validity_limit*config->validity_limit))) { /* in the linear range, with enough to hear */
                state->lately_fall = state->lately_fall + (inv_spread*signature_fall*trust*(innovation - R(0.5)*signature_fall) - state->lately_fall)*((R(1.0)) < (sample->dt*config->gain_rate) ? R(1.0) : sample->dt*config->gain_rate);
                const bicycle_monitor_real lean_fall = state->smooth_same - state->smooth_fall; /* the signature's slow part */
                if (lean_fall*state->side_fall <= R(0.0)) { /* the next half-wave */
                    state->side_fall = lean_fall;
                    state->piece_fall = R(0.0);
                }
                const bicycle_monitor_real gained_fall = (((-gain_bound)) > (((gain_bound) < (state->lately_fall) ? gain_bound : state->lately_fall)) ? (-gain_bound) : ((gain_bound) < (state->lately_fall) ? gain_bound : state->lately_fall));
                const bicycle_monitor_real beyond_fall = (state->rough_fall < config->piece_fit*state->rough_same ? state->lately_fall*config->piece_share : R(0.0)); /* what a half-wave that is used up still counts for */
                const bicycle_monitor_real allowed_fall = ((gained_fall) < (((beyond_fall) > (config->piece_most - state->piece_fall) ? beyond_fall : config->piece_most - state->piece_fall)) ? gained_fall : ((beyond_fall) > (config->piece_most - state->piece_fall) ? beyond_fall : config->piece_most - state->piece_fall));
                state->piece_fall = allowed_fall + state->piece_fall;
                state->evidence_fall = allowed_fall + state->evidence_fall*(R(1.0) - ((R(1.0)) < (sample->dt*config->evidence_leak) ? R(1.0) : sample->dt*config->evidence_leak));
                state->age_fall = state->age_fall + sample->dt;
                const bicycle_monitor_real slope_fall = signature_fall/state->size_fall; /* of the innovation to ln K */
                state->weight_sum_fall = state->weight_sum_fall + inv_spread*weight*(slope_fall*slope_fall);
                state->score_sum_fall = state->score_sum_fall + innovation*inv_spread*slope_fall*weight;
                if ((state->age_fall > config->age_most) || (state->evidence_fall <= (-config->evidence_floor))) { /* nothing speaks for it */
                    state->evidence_fall = R(0.0);
                    state->age_fall = R(0.0);
                    state->weight_sum_fall = R(0.0);
                    state->score_sum_fall = R(0.0);
                    state->lately_fall = R(0.0);
                    state->side_fall = R(0.0);
                    state->piece_fall = R(0.0);
                    state->v_star_fall = state->v_star_plain;
                    state->r_star_fall = state->r_star_plain;
                    state->smooth_fall = state->smooth_same;
                    state->rough_fall = state->rough_same;
                    state->v_star_miss_fall = R(0.0);
                    state->r_star_miss_fall = R(0.0);
                    state->disturbance_miss_fall = R(0.0);
                }
                state->lately_rise = state->lately_rise + (inv_spread*signature_rise*trust*(innovation - R(0.5)*signature_rise) - state->lately_rise)*((R(1.0)) < (sample->dt*config->gain_rate) ? R(1.0) : sample->dt*config->gain_rate);
                const bicycle_monitor_real lean_rise = state->smooth_same - state->smooth_rise; /* the signature's slow part */
                if (lean_rise*state->side_rise <= R(0.0)) { /* the next half-wave */
                    state->side_rise = lean_rise;
                    state->piece_rise = R(0.0);
                }
                const bicycle_monitor_real gained_rise = (((-gain_bound)) > (((gain_bound) < (state->lately_rise) ? gain_bound : state->lately_rise)) ? (-gain_bound) : ((gain_bound) < (state->lately_rise) ? gain_bound : state->lately_rise));
                const bicycle_monitor_real beyond_rise = (state->rough_rise < config->piece_fit*state->rough_same ? state->lately_rise*config->piece_share : R(0.0)); /* what a half-wave that is used up still counts for */
                const bicycle_monitor_real allowed_rise = ((gained_rise) < (((beyond_rise) > (config->piece_most - state->piece_rise) ? beyond_rise : config->piece_most - state->piece_rise)) ? gained_rise : ((beyond_rise) > (config->piece_most - state->piece_rise) ? beyond_rise : config->piece_most - state->piece_rise));
                state->piece_rise = allowed_rise + state->piece_rise;
                state->evidence_rise = allowed_rise + state->evidence_rise*(R(1.0) - ((R(1.0)) < (sample->dt*config->evidence_leak) ? R(1.0) : sample->dt*config->evidence_leak));
                state->age_rise = state->age_rise + sample->dt;
                const bicycle_monitor_real slope_rise = signature_rise/state->size_rise; /* of the innovation to ln K */
                state->weight_sum_rise = state->weight_sum_rise + inv_spread*weight*(slope_rise*slope_rise);
                state->score_sum_rise = state->score_sum_rise + innovation*inv_spread*slope_rise*weight;
                if ((state->age_rise > config->age_most) || (state->evidence_rise <= (-config->evidence_floor))) { /* nothing speaks for it */
                    state->evidence_rise = R(0.0);
                    state->age_rise = R(0.0);
                    state->weight_sum_rise = R(0.0);
                    state->score_sum_rise = R(0.0);
                    state->lately_rise = R(0.0);
                    state->side_rise = R(0.0);
                    state->piece_rise = R(0.0);
                    state->v_star_rise = state->v_star_plain;
                    state->r_star_rise = state->r_star_plain;
                    state->smooth_rise = state->smooth_same;
                    state->rough_rise = state->rough_same;
                    state->v_star_miss_rise = R(0.0);
                    state->r_star_miss_rise = R(0.0);
                    state->disturbance_miss_rise = R(0.0);
                }
                if (((state->evidence_fall - config->small_price*((R(0.0)) > (state->size_fall + config->size_large) ? R(0.0) : state->size_fall + config->size_large)) > config->threshold_fall) && ((state->size_fall*state->size_fall) > config->sizes_squared*state->variance_held) && (state->rough_fall < (config->rough_free + state->rough_same*config->rough_share))) { /* a fall */
                    alarm = R(1.0);
                    onset_age = state->age_fall;
                    change = state->size_fall;
                    change_variance = doubt/(config->size_weight + state->weight_sum_fall);
                }
                if (((state->evidence_rise - config->small_price*((R(0.0)) > (config->size_large - state->size_rise) ? R(0.0) : config->size_large - state->size_rise)) > config->threshold_rise) && ((state->size_rise*state->size_rise) > config->sizes_squared*state->variance_held) && (state->rough_rise < (config->rough_free + state->rough_same*config->rough_share))) { /* a rise */
                    alarm = R(2.0);
                    onset_age = state->age_rise;
                    change = state->size_rise;
                    change_variance = doubt/(config->size_weight + state->weight_sum_rise);
                }
                if (alarm > R(0.5)) { /* the reference is learnt anew */
                    state->evidence_fall = R(0.0);
                    state->age_fall = R(0.0);
                    state->weight_sum_fall = R(0.0);
                    state->score_sum_fall = R(0.0);
                    state->lately_fall = R(0.0);
                    state->side_fall = R(0.0);
                    state->piece_fall = R(0.0);
                    state->v_star_fall = state->v_star_plain;
                    state->r_star_fall = state->r_star_plain;
                    state->smooth_fall = state->smooth_same;
                    state->rough_fall = state->rough_same;
                    state->v_star_miss_fall = R(0.0);
                    state->r_star_miss_fall = R(0.0);
                    state->disturbance_miss_fall = R(0.0);
                    state->evidence_rise = R(0.0);
                    state->age_rise = R(0.0);
                    state->weight_sum_rise = R(0.0);
                    state->score_sum_rise = R(0.0);
                    state->lately_rise = R(0.0);
                    state->side_rise = R(0.0);
                    state->piece_rise = R(0.0);
                    state->v_star_rise = state->v_star_plain;
                    state->r_star_rise = state->r_star_plain;
                    state->smooth_rise = state->smooth_same;
                    state->rough_rise = state->rough_same;
                    state->v_star_miss_rise = R(0.0);
                    state->r_star_miss_rise = R(0.0);
                    state->disturbance_miss_rise = R(0.0);
                    state->heard = config->heard_least - config->heard_again;
                }
            }
        }
        state->last_input = u_now;
        state->last_U = U_used;
    } else {
        status = 7;
    }
    reference = state->K_held;
    evidence_of_fall = state->evidence_fall - config->small_price*((R(0.0)) > (state->size_fall + config->size_large) ? R(0.0) : state->size_fall + config->size_large);
    evidence_of_rise = state->evidence_rise - config->small_price*((R(0.0)) > (config->size_large - state->size_rise) ? R(0.0) : config->size_large - state->size_rise);
    armed = ((state->heard > config->heard_least) && (state->hearing > config->hearing_least) && (state->known > config->known_least) ? R(1.0) : R(0.0));
    information_rate = state->hearing;

    output->alarm = alarm;
    output->onset_age = onset_age;
    output->change = change;
    output->change_variance = change_variance;
    output->reference = reference;
    output->evidence_of_fall = evidence_of_fall;
    output->evidence_of_rise = evidence_of_rise;
    output->armed = armed;
    output->information_rate = information_rate;
    return status;
}

/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int bicycle_monitor_step(const bicycle_monitor_config *config, bicycle_monitor_state *state,
                               const bicycle_monitor_sample *sample, bicycle_monitor_output *output)
{
    return bicycle_monitor_advance(config, state, sample, output);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long bicycle_monitor_batch(const bicycle_monitor_config *config, bicycle_monitor_state *state, long n,
                                 const bicycle_monitor_sample *samples, bicycle_monitor_output *outputs, int *status)
{
    bicycle_monitor_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = bicycle_monitor_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}
