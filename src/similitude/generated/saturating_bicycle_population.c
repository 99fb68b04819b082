/* Population filter of the saturating_bicycle. Generated from its model by similitude; do not edit.
 *
 *   model: saturating_bicycle, Brennan & Alleyne 2004, eqs 1-4, with saturating tyres
 *   base: m, L, U
 *   unknowns: K, pi1, eta, rho, grip
 *   coordinates: v_star, r_star, disturbance, K, pi1, eta, rho, grip, input_scale, input_offset, output_bias
 *
 * Operations: step 1495 at most, 88 at least (arithmetic, comparisons, selects), init 7.
 * Memory: state 98 reals, configuration 79 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL saturating_bicycle_population_real;
#define R(x) ((saturating_bicycle_population_real)(x))

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

enum saturating_bicycle_population_status {
    SATURATING_BICYCLE_POPULATION_OK = 0,
    SATURATING_BICYCLE_POPULATION_NOT_EXCITED = 1,
    SATURATING_BICYCLE_POPULATION_OUTSIDE_LINEAR = 2,
    SATURATING_BICYCLE_POPULATION_AT_LIMIT = 3,
    SATURATING_BICYCLE_POPULATION_NO_MEASUREMENT = 4,
    SATURATING_BICYCLE_POPULATION_RESTARTED = 5,
    SATURATING_BICYCLE_POPULATION_TOO_SLOW = 6,
    SATURATING_BICYCLE_POPULATION_BAD_SAMPLE = 7
};

typedef struct saturating_bicycle_population_config {
    saturating_bicycle_population_real L;            /* [m] wheelbase */
    saturating_bicycle_population_real K_prior;      /* [m^2/s^2] prior of Caf L/m, front cornering stiffness per mass and length */
    saturating_bicycle_population_real pi1_prior;    /* [-] prior of a/L, position of the centre of gravity */
    saturating_bicycle_population_real eta_prior;    /* [-] prior of rear over front cornering coefficient; > 1 understeers */
    saturating_bicycle_population_real rho_prior;    /* [-] prior of Iz/(m a b), yaw inertia ratio */
    saturating_bicycle_population_real grip_prior;   /* [m/s^2] prior of mu g, greatest lateral acceleration */
    saturating_bicycle_population_real P_prior[15];  /* [-] prior covariance of the unknowns' coordinates, upper triangle */
    saturating_bicycle_population_real prior_information; /* [-] 1/prior variance of ln K */
    saturating_bicycle_population_real K_low;        /* [m^2/s^2] lowest value the population allows */
    saturating_bicycle_population_real K_high;       /* [m^2/s^2] highest value the population allows */
    saturating_bicycle_population_real pi1_low;      /* [-] lowest value the population allows */
    saturating_bicycle_population_real pi1_high;     /* [-] highest value the population allows */
    saturating_bicycle_population_real eta_low;      /* [-] lowest value the population allows */
    saturating_bicycle_population_real eta_high;     /* [-] highest value the population allows */
    saturating_bicycle_population_real rho_low;      /* [-] lowest value the population allows */
    saturating_bicycle_population_real rho_high;     /* [-] highest value the population allows */
    saturating_bicycle_population_real grip_low;     /* [m/s^2] lowest value the population allows */
    saturating_bicycle_population_real grip_high;    /* [m/s^2] highest value the population allows */
    saturating_bicycle_population_real input_scale_sd; /* [-] sd of the scale of delta, also that of the known scales */
    saturating_bicycle_population_real input_scale_low; /* [-] least scale of delta */
    saturating_bicycle_population_real input_scale_high; /* [-] greatest scale of delta */
    saturating_bicycle_population_real input_offset_sd; /* [rad] prior sd of the offset of delta */
    saturating_bicycle_population_real output_bias_sd; /* [rad/s] prior sd of the bias of r */
    saturating_bicycle_population_real v_star_sd;    /* [-] sd after a restart */
    saturating_bicycle_population_real r_star_sd;    /* [-] sd after a restart */
    saturating_bicycle_population_real noise_variance; /* [(rad/s)^2] white noise of r a sample */
    saturating_bicycle_population_real drift;        /* [1/s] diffusion of ln K while it is observed */
    saturating_bicycle_population_real idle_drift;   /* [1/s] diffusion of ln K while nothing is heard of it */
    saturating_bicycle_population_real jump_drift;   /* [1/s] further diffusion per unit of surprise above its limit */
    saturating_bicycle_population_real bias_drift;   /* [(rad/s)^2/s] random walk of the output bias */
    saturating_bicycle_population_real timing_error; /* [s] timing error between input and output */
    saturating_bicycle_population_real companion_rate; /* [1/s] rate at which the uncorrected states follow the estimate */
    saturating_bicycle_population_real offset_rate;  /* [1/s] rate at which the uncorrected states' offset follows the estimate */
    saturating_bicycle_population_real structure_share; /* [-] structural error as a share of the output's activity */
    saturating_bicycle_population_real structure_time; /* [s] correlation time of the structural error */
    saturating_bicycle_population_real activity_rate; /* [1/s] averaging rate of the output's activity */
    saturating_bicycle_population_real disturbance_floor; /* [rad] disturbance at rest, equivalent input */
    saturating_bicycle_population_real disturbance_share; /* [-] disturbance as a share of the dimensionless activity */
    saturating_bicycle_population_real disturbance_rate; /* [1/s] 1/correlation time of the disturbance */
    saturating_bicycle_population_real disturbance_adapt; /* [1/s] adaptation rate of the disturbance's size */
    saturating_bicycle_population_real disturbance_scale_start; /* [-] disturbance variance against nominal at the start */
    saturating_bicycle_population_real disturbance_scale_low; /* [-] least disturbance variance against nominal */
    saturating_bicycle_population_real disturbance_scale_high; /* [-] greatest disturbance variance against nominal */
    saturating_bicycle_population_real noise_adapt;  /* [1/s] adaptation rate of the noise's size in the long run */
    saturating_bicycle_population_real noise_scale_low; /* [-] least noise variance against nominal */
    saturating_bicycle_population_real noise_scale_high; /* [-] greatest noise variance against nominal */
    saturating_bicycle_population_real excitation_ratio; /* [-] least variance of sensitivity against noise to learn from */
    saturating_bicycle_population_real excitation_rate; /* [1/s] averaging rate of the excitation */
    saturating_bicycle_population_real seldom;       /* [s] least time between samples that the seldom learnt unknowns learn from */
    saturating_bicycle_population_real beyond_time;  /* [s] beyond the linear range all but grip learn so seldom */
    saturating_bicycle_population_real slow_doubt;   /* [-] share of ln K's variance from learnt constants that is added to it */
    saturating_bicycle_population_real surprise_rate; /* [1/s] averaging rate of the normalised innovation */
    saturating_bicycle_population_real jump_ratio;   /* [-] squared surprise against its long-run mean that speaks of a jump */
    saturating_bicycle_population_real surprise_limit; /* [-] mean squared normalised innovation that speaks of a jump */
    saturating_bicycle_population_real heard_rate;   /* [1/s] rate at which what was told of the first unknown is forgotten */
    saturating_bicycle_population_real faint_drift;  /* [1/s] further diffusion of ln K while a jump could not show */
    saturating_bicycle_population_real inv_telling;  /* [-] 1/information of late in which a jump shows */
    saturating_bicycle_population_real observed_least; /* [-] least share of the disturbance taken as observed */
    saturating_bicycle_population_real outlier_ratio; /* [-] squared innovation over its variance beyond which it is bounded */
    saturating_bicycle_population_real gap;          /* [s] longest time without a usable sample before a restart */
    saturating_bicycle_population_real input_limit;  /* [rad] greatest believable delta */
    saturating_bicycle_population_real output_limit; /* [rad/s] greatest believable r */
    saturating_bicycle_population_real signal_limit; /* [m/s] greatest believable scale */
    saturating_bicycle_population_real validity_limit; /* [m/s^2] edge of the model's linear range */
    saturating_bicycle_population_real validity_rate; /* [1/s] decay rate of the memory of a visit outside the linear range */
} saturating_bicycle_population_config;

typedef struct saturating_bicycle_population_state {
    saturating_bicycle_population_real v_star;       /* [-] dimensionless state */
    saturating_bicycle_population_real r_star;       /* [-] dimensionless state */
    saturating_bicycle_population_real v_star_plain; /* [-] the same, not corrected by measurements */
    saturating_bicycle_population_real r_star_plain; /* [-] the same, not corrected by measurements */
    saturating_bicycle_population_real input_offset_plain; /* [rad] its offset: the estimated one, followed slowly */
    saturating_bicycle_population_real disturbance;  /* [rad] disturbance as an equivalent delta */
    saturating_bicycle_population_real K;            /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    saturating_bicycle_population_real pi1;          /* [-] a/L, position of the centre of gravity */
    saturating_bicycle_population_real eta;          /* [-] rear over front cornering coefficient; > 1 understeers */
    saturating_bicycle_population_real rho;          /* [-] Iz/(m a b), yaw inertia ratio */
    saturating_bicycle_population_real grip;         /* [m/s^2] mu g, greatest lateral acceleration */
    saturating_bicycle_population_real input_scale;  /* [-] delta that acts over delta measured */
    saturating_bicycle_population_real input_offset; /* [rad] offset of delta */
    saturating_bicycle_population_real output_bias;  /* [rad/s] bias of r */
    saturating_bicycle_population_real P[66];        /* [-] covariance of the coordinates above, upper triangle by rows */
    saturating_bicycle_population_real noise_scale;  /* [-] noise variance against nominal */
    saturating_bicycle_population_real disturbance_scale; /* [-] disturbance variance against nominal */
    saturating_bicycle_population_real activity;     /* [(rad/s)^2] mean square of the predicted output */
    saturating_bicycle_population_real settling;     /* [1/s] adaptation rate of the noise's size now, fast at first */
    saturating_bicycle_population_real restlessness; /* [-] long-run mean square of the surprise beyond one */
    saturating_bicycle_population_real jump;         /* [-] surprise taken as a jump of the first unknown */
    saturating_bicycle_population_real surprise;     /* [-] recent mean of the normalised innovation squared */
    saturating_bicycle_population_real heard;        /* [-] recent information about the first unknown */
    saturating_bicycle_population_real excitation;   /* [(rad/s)^2] mean square sensitivity to the first unknown */
    saturating_bicycle_population_real excited;      /* [-] 1 while the input excites the first unknown, else 0 */
    saturating_bicycle_population_real unlearnt;     /* [s] time since the seldom learnt unknowns last learnt anything */
    saturating_bicycle_population_real untaught;     /* [s] time since a sample last taught more than grip */
    saturating_bicycle_population_real validity;     /* [(m/s^2)^2] recent peak of the validity signal, squared */
    saturating_bicycle_population_real information;  /* [-] information gained about ln K */
    saturating_bicycle_population_real last_input;   /* [rad] input of the sample before */
    saturating_bicycle_population_real last_U;       /* [m/s] forward speed of the sample before */
    saturating_bicycle_population_real age;          /* [s] time since the last usable sample */
    saturating_bicycle_population_real started;      /* [-] 1 once a sample was used; 0 again while the scales hide the dynamics */
} saturating_bicycle_population_state;

typedef struct saturating_bicycle_population_sample {
    saturating_bicycle_population_real dt;           /* [s] time since the sample before */
    saturating_bicycle_population_real input;        /* [rad] road-wheel steer angle */
    saturating_bicycle_population_real U;            /* [m/s] forward speed */
    saturating_bicycle_population_real measured;     /* [rad/s] measured yaw rate */
} saturating_bicycle_population_sample;

typedef struct saturating_bicycle_population_output {
    saturating_bicycle_population_real estimate;     /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    saturating_bicycle_population_real variance;     /* [-] variance of ln K */
    saturating_bicycle_population_real predicted;    /* [rad/s] yaw rate predicted before the measurement */
    saturating_bicycle_population_real innovation;   /* [rad/s] measured minus predicted; 0 without a measurement */
    saturating_bicycle_population_real innovation_variance; /* [(rad/s)^2] variance of the innovation */
    saturating_bicycle_population_real information_gained; /* [-] information gained about ln K so far */
    saturating_bicycle_population_real own_variance; /* [-] variance of ln K that the filter goes by */
    saturating_bicycle_population_real pi1_now;      /* [-] a/L, position of the centre of gravity */
    saturating_bicycle_population_real eta_now;      /* [-] rear over front cornering coefficient; > 1 understeers */
    saturating_bicycle_population_real rho_now;      /* [-] Iz/(m a b), yaw inertia ratio */
    saturating_bicycle_population_real grip_now;     /* [m/s^2] mu g, greatest lateral acceleration */
    saturating_bicycle_population_real offset_now;   /* [rad] offset of delta */
    saturating_bicycle_population_real bias_now;     /* [rad/s] bias of r */
    saturating_bicycle_population_real noise_now;    /* [(rad/s)^2] variance of the measurement */
    saturating_bicycle_population_real disturbance_now; /* [(rad)^2] variance of the disturbance in the long run */
} saturating_bicycle_population_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void saturating_bicycle_population_init(const saturating_bicycle_population_config *config, saturating_bicycle_population_state *state)
{
    saturating_bicycle_population_real *const P = state->P;
    int i;
    for (i = 0; i < 66; ++i) {
        P[i] = R(0.0);
    }
    state->v_star = R(0.0);
    state->r_star = R(0.0);
    state->v_star_plain = R(0.0);
    state->r_star_plain = R(0.0);
    state->disturbance = R(0.0);
    state->K = config->K_prior;
    state->pi1 = config->pi1_prior;
    state->eta = config->eta_prior;
    state->rho = config->rho_prior;
    state->grip = config->grip_prior;
    state->input_scale = R(1.0);
    state->input_offset = R(0.0);
    state->output_bias = R(0.0);
    P[0] = (config->v_star_sd*config->v_star_sd);
    P[11] = (config->r_star_sd*config->r_star_sd);
    P[60] = (config->input_scale_sd*config->input_scale_sd);
    P[63] = (config->input_offset_sd*config->input_offset_sd);
    P[65] = (config->output_bias_sd*config->output_bias_sd);
    P[30] = config->P_prior[0];
    P[31] = config->P_prior[1];
    P[32] = config->P_prior[2];
    P[33] = config->P_prior[3];
    P[34] = config->P_prior[4];
    P[38] = config->P_prior[5];
    P[39] = config->P_prior[6];
    P[40] = config->P_prior[7];
    P[41] = config->P_prior[8];
    P[45] = config->P_prior[9];
    P[46] = config->P_prior[10];
    P[47] = config->P_prior[11];
    P[51] = config->P_prior[12];
    P[52] = config->P_prior[13];
    P[56] = config->P_prior[14];
    state->noise_scale = R(1.0);
    state->surprise = R(1.0);
    state->settling = R(1.0);
    state->disturbance_scale = config->disturbance_scale_start;
    P[21] = state->disturbance_scale*(config->disturbance_floor*config->disturbance_floor);
    state->restlessness = R(0.0);
    state->jump = R(0.0);
    state->heard = R(0.0);
    state->activity = R(0.0);
    state->excitation = R(0.0);
    state->excited = R(0.0);
    state->unlearnt = R(0.0);
    state->validity = R(0.0);
    state->information = R(0.0);
    state->last_input = R(0.0);
    state->age = R(0.0);
    state->started = R(0.0);
    state->untaught = R(0.0);
    state->last_U = R(0.0);
    state->input_offset_plain = R(0.0);
}

/* A part of the step: propagate. */
SIMILITUDE_PART void saturating_bicycle_population_propagate(
        const saturating_bicycle_population_config *config,
        saturating_bicycle_population_state *state,
        const saturating_bicycle_population_sample *sample,
        const saturating_bicycle_population_real steer,
        const saturating_bicycle_population_real F_v_star_K,
        const saturating_bicycle_population_real F_v_star_eta,
        const saturating_bicycle_population_real F_v_star_grip,
        const saturating_bicycle_population_real F_v_star_pi1,
        const saturating_bicycle_population_real F_v_star_r_star,
        const saturating_bicycle_population_real F_v_star_rho,
        const saturating_bicycle_population_real F_v_star_u,
        const saturating_bicycle_population_real F_v_star_v_star,
        const saturating_bicycle_population_real F_r_star_K,
        const saturating_bicycle_population_real F_r_star_eta,
        const saturating_bicycle_population_real F_r_star_grip,
        const saturating_bicycle_population_real F_r_star_pi1,
        const saturating_bicycle_population_real F_r_star_r_star,
        const saturating_bicycle_population_real F_r_star_rho,
        const saturating_bicycle_population_real F_r_star_u,
        const saturating_bicycle_population_real F_r_star_v_star,
        const saturating_bicycle_population_real keep_w,
        const saturating_bicycle_population_real w_nominal,
        const saturating_bicycle_population_real diffusion)
{
    saturating_bicycle_population_real *const P = state->P;
    const saturating_bicycle_population_real PW_0 = P[2] + P[9] + P[8]*steer;
    const saturating_bicycle_population_real FP_0_0 = F_v_star_K*P[3] + F_v_star_eta*P[5] + F_v_star_grip*P[7] + F_v_star_pi1*P[4] + F_v_star_r_star*P[1] + F_v_star_rho*P[6] + F_v_star_u*PW_0 + F_v_star_v_star*P[0];
    const saturating_bicycle_population_real FP_1_0 = F_r_star_K*P[3] + F_r_star_eta*P[5] + F_r_star_grip*P[7] + F_r_star_pi1*P[4] + F_r_star_r_star*P[1] + F_r_star_rho*P[6] + F_r_star_u*PW_0 + F_r_star_v_star*P[0];
    const saturating_bicycle_population_real PW_1 = P[12] + P[19] + P[18]*steer;
    const saturating_bicycle_population_real FP_0_1 = F_v_star_K*P[13] + F_v_star_eta*P[15] + F_v_star_grip*P[17] + F_v_star_pi1*P[14] + F_v_star_r_star*P[11] + F_v_star_rho*P[16] + F_v_star_u*PW_1 + F_v_star_v_star*P[1];
    const saturating_bicycle_population_real FP_1_1 = F_r_star_K*P[13] + F_r_star_eta*P[15] + F_r_star_grip*P[17] + F_r_star_pi1*P[14] + F_r_star_r_star*P[11] + F_r_star_rho*P[16] + F_r_star_u*PW_1 + F_r_star_v_star*P[1];
    P[0] = FP_0_0*F_v_star_v_star + FP_0_1*F_v_star_r_star;
    P[1] = FP_0_0*F_r_star_v_star + FP_0_1*F_r_star_r_star;
    P[11] = FP_1_0*F_r_star_v_star + FP_1_1*F_r_star_r_star;
    const saturating_bicycle_population_real PW_2 = P[21] + P[28] + P[27]*steer;
    const saturating_bicycle_population_real FP_0_2 = F_v_star_K*P[22] + F_v_star_eta*P[24] + F_v_star_grip*P[26] + F_v_star_pi1*P[23] + F_v_star_r_star*P[12] + F_v_star_rho*P[25] + F_v_star_u*PW_2 + F_v_star_v_star*P[2];
    const saturating_bicycle_population_real FP_1_2 = F_r_star_K*P[22] + F_r_star_eta*P[24] + F_r_star_grip*P[26] + F_r_star_pi1*P[23] + F_r_star_r_star*P[12] + F_r_star_rho*P[25] + F_r_star_u*PW_2 + F_r_star_v_star*P[2];
    P[2] = FP_0_2*keep_w;
    P[12] = FP_1_2*keep_w;
    const saturating_bicycle_population_real PW_3 = P[22] + P[36] + P[35]*steer;
    const saturating_bicycle_population_real FP_0_3 = F_v_star_K*P[30] + F_v_star_eta*P[32] + F_v_star_grip*P[34] + F_v_star_pi1*P[31] + F_v_star_r_star*P[13] + F_v_star_rho*P[33] + F_v_star_u*PW_3 + F_v_star_v_star*P[3];
    const saturating_bicycle_population_real FP_1_3 = F_r_star_K*P[30] + F_r_star_eta*P[32] + F_r_star_grip*P[34] + F_r_star_pi1*P[31] + F_r_star_r_star*P[13] + F_r_star_rho*P[33] + F_r_star_u*PW_3 + F_r_star_v_star*P[3];
    P[3] = FP_0_3;
    P[13] = FP_1_3;
    P[0] = P[0] + FP_0_3*F_v_star_K;
    P[1] = P[1] + FP_0_3*F_r_star_K;
    P[11] = P[11] + FP_1_3*F_r_star_K;
    const saturating_bicycle_population_real PW_4 = P[23] + P[43] + P[42]*steer;
    const saturating_bicycle_population_real FP_0_4 = F_v_star_K*P[31] + F_v_star_eta*P[39] + F_v_star_grip*P[41] + F_v_star_pi1*P[38] + F_v_star_r_star*P[14] + F_v_star_rho*P[40] + F_v_star_u*PW_4 + F_v_star_v_star*P[4];
    const saturating_bicycle_population_real FP_1_4 = F_r_star_K*P[31] + F_r_star_eta*P[39] + F_r_star_grip*P[41] + F_r_star_pi1*P[38] + F_r_star_r_star*P[14] + F_r_star_rho*P[40] + F_r_star_u*PW_4 + F_r_star_v_star*P[4];
    P[4] = FP_0_4;
    P[14] = FP_1_4;
    P[0] = P[0] + FP_0_4*F_v_star_pi1;
    P[1] = P[1] + FP_0_4*F_r_star_pi1;
    P[11] = P[11] + FP_1_4*F_r_star_pi1;
    const saturating_bicycle_population_real PW_5 = P[24] + P[49] + P[48]*steer;
    const saturating_bicycle_population_real FP_0_5 = F_v_star_K*P[32] + F_v_star_eta*P[45] + F_v_star_grip*P[47] + F_v_star_pi1*P[39] + F_v_star_r_star*P[15] + F_v_star_rho*P[46] + F_v_star_u*PW_5 + F_v_star_v_star*P[5];
    const saturating_bicycle_population_real FP_1_5 = F_r_star_K*P[32] + F_r_star_eta*P[45] + F_r_star_grip*P[47] + F_r_star_pi1*P[39] + F_r_star_r_star*P[15] + F_r_star_rho*P[46] + F_r_star_u*PW_5 + F_r_star_v_star*P[5];
    P[5] = FP_0_5;
    P[15] = FP_1_5;
    P[0] = P[0] + FP_0_5*F_v_star_eta;
    P[1] = P[1] + FP_0_5*F_r_star_eta;
    P[11] = P[11] + FP_1_5*F_r_star_eta;
    const saturating_bicycle_population_real PW_6 = P[25] + P[54] + P[53]*steer;
    const saturating_bicycle_population_real FP_0_6 = F_v_star_K*P[33] + F_v_star_eta*P[46] + F_v_star_grip*P[52] + F_v_star_pi1*P[40] + F_v_star_r_star*P[16] + F_v_star_rho*P[51] + F_v_star_u*PW_6 + F_v_star_v_star*P[6];
    const saturating_bicycle_population_real FP_1_6 = F_r_star_K*P[33] + F_r_star_eta*P[46] + F_r_star_grip*P[52] + F_r_star_pi1*P[40] + F_r_star_r_star*P[16] + F_r_star_rho*P[51] + F_r_star_u*PW_6 + F_r_star_v_star*P[6];
    P[6] = FP_0_6;
    P[16] = FP_1_6;
    P[0] = P[0] + FP_0_6*F_v_star_rho;
    P[1] = P[1] + FP_0_6*F_r_star_rho;
    P[11] = P[11] + FP_1_6*F_r_star_rho;
    const saturating_bicycle_population_real PW_7 = P[26] + P[58] + P[57]*steer;
    const saturating_bicycle_population_real FP_0_7 = F_v_star_K*P[34] + F_v_star_eta*P[47] + F_v_star_grip*P[56] + F_v_star_pi1*P[41] + F_v_star_r_star*P[17] + F_v_star_rho*P[52] + F_v_star_u*PW_7 + F_v_star_v_star*P[7];
    const saturating_bicycle_population_real FP_1_7 = F_r_star_K*P[34] + F_r_star_eta*P[47] + F_r_star_grip*P[56] + F_r_star_pi1*P[41] + F_r_star_r_star*P[17] + F_r_star_rho*P[52] + F_r_star_u*PW_7 + F_r_star_v_star*P[7];
    P[7] = FP_0_7;
    P[17] = FP_1_7;
    P[0] = P[0] + FP_0_7*F_v_star_grip;
    P[1] = P[1] + FP_0_7*F_r_star_grip;
    P[11] = P[11] + FP_1_7*F_r_star_grip;
    const saturating_bicycle_population_real PW_8 = P[27] + P[61] + P[60]*steer;
    const saturating_bicycle_population_real FP_0_8 = F_v_star_K*P[35] + F_v_star_eta*P[48] + F_v_star_grip*P[57] + F_v_star_pi1*P[42] + F_v_star_r_star*P[18] + F_v_star_rho*P[53] + F_v_star_u*PW_8 + F_v_star_v_star*P[8];
    const saturating_bicycle_population_real FP_1_8 = F_r_star_K*P[35] + F_r_star_eta*P[48] + F_r_star_grip*P[57] + F_r_star_pi1*P[42] + F_r_star_r_star*P[18] + F_r_star_rho*P[53] + F_r_star_u*PW_8 + F_r_star_v_star*P[8];
    P[8] = FP_0_8;
    P[18] = FP_1_8;
    const saturating_bicycle_population_real PW_9 = P[28] + P[63] + P[61]*steer;
    const saturating_bicycle_population_real FP_0_9 = F_v_star_K*P[36] + F_v_star_eta*P[49] + F_v_star_grip*P[58] + F_v_star_pi1*P[43] + F_v_star_r_star*P[19] + F_v_star_rho*P[54] + F_v_star_u*PW_9 + F_v_star_v_star*P[9];
    const saturating_bicycle_population_real FP_1_9 = F_r_star_K*P[36] + F_r_star_eta*P[49] + F_r_star_grip*P[58] + F_r_star_pi1*P[43] + F_r_star_r_star*P[19] + F_r_star_rho*P[54] + F_r_star_u*PW_9 + F_r_star_v_star*P[9];
    P[9] = FP_0_9;
    P[19] = FP_1_9;
    const saturating_bicycle_population_real PW_10 = P[29] + P[64] + P[62]*steer;
    const saturating_bicycle_population_real FP_0_10 = F_v_star_K*P[37] + F_v_star_eta*P[50] + F_v_star_grip*P[59] + F_v_star_pi1*P[44] + F_v_star_r_star*P[20] + F_v_star_rho*P[55] + F_v_star_u*PW_10 + F_v_star_v_star*P[10];
    const saturating_bicycle_population_real FP_1_10 = F_r_star_K*P[37] + F_r_star_eta*P[50] + F_r_star_grip*P[59] + F_r_star_pi1*P[44] + F_r_star_r_star*P[20] + F_r_star_rho*P[55] + F_r_star_u*PW_10 + F_r_star_v_star*P[10];
    P[10] = FP_0_10;
    P[20] = FP_1_10;
    const saturating_bicycle_population_real WPF_0 = FP_0_2 + FP_0_9 + FP_0_8*steer;
    const saturating_bicycle_population_real WPF_1 = FP_1_2 + FP_1_9 + FP_1_8*steer;
    P[0] = P[0] + F_v_star_u*WPF_0;
    P[1] = P[1] + F_r_star_u*WPF_0;
    P[11] = P[11] + F_r_star_u*WPF_1;
    P[21] = P[21]*(keep_w*keep_w) + state->disturbance_scale*w_nominal*(R(1.0) - (keep_w*keep_w));
    P[22] = P[22]*keep_w;
    P[23] = P[23]*keep_w;
    P[24] = P[24]*keep_w;
    P[25] = P[25]*keep_w;
    P[26] = P[26]*keep_w;
    P[27] = P[27]*keep_w;
    P[28] = P[28]*keep_w;
    P[29] = P[29]*keep_w;
    P[30] = P[30] + sample->dt*(diffusion + state->jump*config->jump_drift);
    P[65] = P[65] + config->bias_drift*sample->dt;
}

/* A part of the step: correct. */
SIMILITUDE_PART void saturating_bicycle_population_correct(
        saturating_bicycle_population_state *state,
        const saturating_bicycle_population_real output_scale,
        const saturating_bicycle_population_real inv_spread,
        const saturating_bicycle_population_real c_1,
        const saturating_bicycle_population_real learn_seldom,
        const saturating_bicycle_population_real learn_slow,
        const saturating_bicycle_population_real learn_beyond,
        const saturating_bicycle_population_real c_10,
        const saturating_bicycle_population_real c_3,
        const saturating_bicycle_population_real gain_3,
        const saturating_bicycle_population_real innovation)
{
    saturating_bicycle_population_real *const P = state->P;
    const saturating_bicycle_population_real c_0 = P[10] + P[1]*output_scale;
    const saturating_bicycle_population_real c_2 = P[29] + P[12]*output_scale;
    const saturating_bicycle_population_real c_4 = P[44] + P[14]*output_scale;
    const saturating_bicycle_population_real c_5 = P[50] + P[15]*output_scale;
    const saturating_bicycle_population_real c_6 = P[55] + P[16]*output_scale;
    const saturating_bicycle_population_real c_7 = P[59] + P[17]*output_scale;
    const saturating_bicycle_population_real c_8 = P[62] + P[18]*output_scale;
    const saturating_bicycle_population_real c_9 = P[64] + P[19]*output_scale;
    const saturating_bicycle_population_real gain_0 = c_0*inv_spread;
    const saturating_bicycle_population_real gain_1 = c_1*inv_spread;
    const saturating_bicycle_population_real gain_2 = c_2*inv_spread;
    const saturating_bicycle_population_real gain_4 = c_4*learn_seldom;
    const saturating_bicycle_population_real gain_5 = c_5*learn_slow;
    const saturating_bicycle_population_real gain_6 = c_6*learn_slow;
    const saturating_bicycle_population_real gain_7 = c_7*learn_beyond;
    const saturating_bicycle_population_real gain_8 = c_8*learn_slow;
    const saturating_bicycle_population_real gain_9 = c_9*inv_spread;
    const saturating_bicycle_population_real gain_10 = c_10*inv_spread;
    P[0] = P[0] - c_0*gain_0;
    P[1] = P[1] - c_1*gain_0;
    P[2] = P[2] - c_2*gain_0;
    P[3] = P[3] - c_3*gain_0;
    P[4] = P[4] - c_4*gain_0;
    P[5] = P[5] - c_5*gain_0;
    P[6] = P[6] - c_6*gain_0;
    P[7] = P[7] - c_7*gain_0;
    P[8] = P[8] - c_8*gain_0;
    P[9] = P[9] - c_9*gain_0;
    P[10] = P[10] - c_10*gain_0;
    P[11] = P[11] - c_1*gain_1;
    P[12] = P[12] - c_2*gain_1;
    P[13] = P[13] - c_3*gain_1;
    P[14] = P[14] - c_4*gain_1;
    P[15] = P[15] - c_5*gain_1;
    P[16] = P[16] - c_6*gain_1;
    P[17] = P[17] - c_7*gain_1;
    P[18] = P[18] - c_8*gain_1;
    P[19] = P[19] - c_9*gain_1;
    P[20] = P[20] - c_10*gain_1;
    P[21] = P[21] - c_2*gain_2;
    P[22] = P[22] - c_3*gain_2;
    P[23] = P[23] - c_4*gain_2;
    P[24] = P[24] - c_5*gain_2;
    P[25] = P[25] - c_6*gain_2;
    P[26] = P[26] - c_7*gain_2;
    P[27] = P[27] - c_8*gain_2;
    P[28] = P[28] - c_9*gain_2;
    P[29] = P[29] - c_10*gain_2;
    P[30] = P[30] - c_3*gain_3;
    P[31] = P[31] - c_4*gain_3;
    P[32] = P[32] - c_5*gain_3;
    P[33] = P[33] - c_6*gain_3;
    P[34] = P[34] - c_3*gain_7;
    P[35] = P[35] - c_8*gain_3;
    P[36] = P[36] - c_3*gain_9;
    P[37] = P[37] - c_3*gain_10;
    P[38] = P[38] - c_4*gain_4;
    P[39] = P[39] - c_4*gain_5;
    P[40] = P[40] - c_4*gain_6;
    P[41] = P[41] - c_4*gain_7;
    P[42] = P[42] - c_4*gain_8;
    P[43] = P[43] - c_4*gain_9;
    P[44] = P[44] - c_4*gain_10;
    P[45] = P[45] - c_5*gain_5;
    P[46] = P[46] - c_6*gain_5;
    P[47] = P[47] - c_5*gain_7;
    P[48] = P[48] - c_8*gain_5;
    P[49] = P[49] - c_5*gain_9;
    P[50] = P[50] - c_5*gain_10;
    P[51] = P[51] - c_6*gain_6;
    P[52] = P[52] - c_6*gain_7;
    P[53] = P[53] - c_8*gain_6;
    P[54] = P[54] - c_6*gain_9;
    P[55] = P[55] - c_6*gain_10;
    P[56] = P[56] - c_7*gain_7;
    P[57] = P[57] - c_8*gain_7;
    P[58] = P[58] - c_7*gain_9;
    P[59] = P[59] - c_7*gain_10;
    P[60] = P[60] - c_8*gain_8;
    P[61] = P[61] - c_8*gain_9;
    P[62] = P[62] - c_8*gain_10;
    P[63] = P[63] - c_9*gain_9;
    P[64] = P[64] - c_10*gain_9;
    P[65] = P[65] - c_10*gain_10;
    state->v_star = state->v_star + gain_0*innovation;
    state->r_star = state->r_star + gain_1*innovation;
    state->disturbance = state->disturbance + gain_2*innovation;
    state->pi1 = state->pi1 + gain_4*innovation;
    const saturating_bicycle_population_real move_eta = gain_5*innovation;
    const saturating_bicycle_population_real above_move_eta = (((-R(1.0))) > (move_eta) ? (-R(1.0)) : move_eta);
    const saturating_bicycle_population_real bounded_move_eta = ((R(1.0)) < (above_move_eta) ? R(1.0) : above_move_eta);
    state->eta = state->eta*(R(1.0) + bounded_move_eta*(R(1.0) + bounded_move_eta*(R(0.5) + R(0.16666666666666666)*bounded_move_eta)));
    const saturating_bicycle_population_real move_rho = gain_6*innovation;
    const saturating_bicycle_population_real above_move_rho = (((-R(1.0))) > (move_rho) ? (-R(1.0)) : move_rho);
    const saturating_bicycle_population_real bounded_move_rho = ((R(1.0)) < (above_move_rho) ? R(1.0) : above_move_rho);
    state->rho = state->rho*(R(1.0) + bounded_move_rho*(R(1.0) + bounded_move_rho*(R(0.5) + R(0.16666666666666666)*bounded_move_rho)));
    const saturating_bicycle_population_real move_grip = gain_7*innovation;
    const saturating_bicycle_population_real above_move_grip = (((-R(1.0))) > (move_grip) ? (-R(1.0)) : move_grip);
    const saturating_bicycle_population_real bounded_move_grip = ((R(1.0)) < (above_move_grip) ? R(1.0) : above_move_grip);
    state->grip = state->grip*(R(1.0) + bounded_move_grip*(R(1.0) + bounded_move_grip*(R(0.5) + R(0.16666666666666666)*bounded_move_grip)));
    const saturating_bicycle_population_real move_input_scale = gain_8*innovation;
    const saturating_bicycle_population_real above_move_input_scale = (((-R(1.0))) > (move_input_scale) ? (-R(1.0)) : move_input_scale);
    const saturating_bicycle_population_real bounded_move_input_scale = ((R(1.0)) < (above_move_input_scale) ? R(1.0) : above_move_input_scale);
    state->input_scale = state->input_scale*(R(1.0) + bounded_move_input_scale*(R(1.0) + bounded_move_input_scale*(R(0.5) + R(0.16666666666666666)*bounded_move_input_scale)));
    state->input_offset = state->input_offset + gain_9*innovation;
    state->output_bias = state->output_bias + gain_10*innovation;
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int saturating_bicycle_population_advance(const saturating_bicycle_population_config *config, saturating_bicycle_population_state *state,
                                     const saturating_bicycle_population_sample *sample, saturating_bicycle_population_output *output)
{
    saturating_bicycle_population_real *const P = state->P;
    saturating_bicycle_population_real U_now = R(0.0);
    int anew = 0;
    saturating_bicycle_population_real bias_now = R(0.0);
    saturating_bicycle_population_real diffusion = R(0.0);
    saturating_bicycle_population_real disturbance_now = R(0.0);
    saturating_bicycle_population_real estimate = R(0.0);
    saturating_bicycle_population_real eta_now = R(0.0);
    saturating_bicycle_population_real grip_now = R(0.0);
    saturating_bicycle_population_real information_gained = R(0.0);
    saturating_bicycle_population_real innovation = R(0.0);
    saturating_bicycle_population_real innovation_variance = R(0.0);
    saturating_bicycle_population_real inv_spread = R(0.0);
    saturating_bicycle_population_real move = R(0.0);
    saturating_bicycle_population_real noise_now = R(0.0);
    saturating_bicycle_population_real offset_now = R(0.0);
    saturating_bicycle_population_real own_variance = R(0.0);
    saturating_bicycle_population_real pi1_now = R(0.0);
    saturating_bicycle_population_real predicted = R(0.0);
    saturating_bicycle_population_real rho_now = R(0.0);
    int status = 0;
    saturating_bicycle_population_real u_now = R(0.0);
    int usable = 0;
    saturating_bicycle_population_real variance = R(0.0);

    status = 0;
    predicted = state->output_bias;
    innovation = R(0.0);
    innovation_variance = state->noise_scale*config->noise_variance;
    noise_now = innovation_variance;
    disturbance_now = state->disturbance_scale*(config->disturbance_floor*config->disturbance_floor);
    if ((sample->dt < R(1000000.0)) && (sample->dt > R(1e-06))) { /* time must advance */
        usable = 1;
        anew = 0; /* 1 where the dynamic state starts anew */
        state->age = state->age + sample->dt;
        if (WITHIN(sample->input, config->input_limit)) { /* a missing one is held */
            u_now = sample->input;
        } else {
            u_now = state->last_input;
            usable = 0;
            status = 4;
        }
        if (WITHIN(sample->U, config->signal_limit)) { /* a missing one is held */
            U_now = sample->U;
        } else {
            U_now = state->last_U;
            usable = 0;
            status = 4;
        }
        if (!(WITHIN(sample->measured, config->output_limit))) { /* no measurement */
            usable = 0;
            status = 4;
        }
        if (state->started < R(0.5)) { /* no sample before it could be used */
            anew = 1;
            state->last_input = u_now;
            state->last_U = U_now;
        }
        if ((state->age > config->gap) && (usable > 0)) { /* the first sample after a gap */
            status = 5;
            anew = 1;
        }
        if (!((R(10.0)*(U_now*U_now) > config->K_prior) && (U_now > R(0.0)))) { /* the dynamics cannot be seen */
            anew = 1;
            state->started = R(0.0);
            usable = 0;
            status = 6;
        }
        if ((anew > 0) || (state->age > config->gap)) { /* nothing was heard for long */
            state->excitation = R(0.0);
            state->excited = R(0.0);
            state->jump = R(0.0);
            state->heard = R(0.0);
            state->surprise = R(1.0);
        }
        if (anew > 0) { /* nothing is known of them */
            P[0] = R(0.0);
            P[1] = R(0.0);
            P[2] = R(0.0);
            P[3] = R(0.0);
            P[4] = R(0.0);
            P[5] = R(0.0);
            P[6] = R(0.0);
            P[7] = R(0.0);
            P[8] = R(0.0);
            P[9] = R(0.0);
            P[10] = R(0.0);
            P[11] = R(0.0);
            P[12] = R(0.0);
            P[13] = R(0.0);
            P[14] = R(0.0);
            P[15] = R(0.0);
            P[16] = R(0.0);
            P[17] = R(0.0);
            P[18] = R(0.0);
            P[19] = R(0.0);
            P[20] = R(0.0);
            P[21] = R(0.0);
            P[22] = R(0.0);
            P[23] = R(0.0);
            P[24] = R(0.0);
            P[25] = R(0.0);
            P[26] = R(0.0);
            P[27] = R(0.0);
            P[28] = R(0.0);
            P[29] = R(0.0);
            P[0] = (config->v_star_sd*config->v_star_sd);
            P[11] = (config->r_star_sd*config->r_star_sd);
            P[21] = state->disturbance_scale*(config->disturbance_floor*config->disturbance_floor);
            state->v_star = R(0.0);
            state->r_star = R(0.0);
            state->v_star_plain = R(0.0);
            state->r_star_plain = R(0.0);
            state->disturbance = R(0.0);
        }
        const saturating_bicycle_population_real least_scale = R(0.0003333333333333333)*config->signal_limit;
        const saturating_bicycle_population_real at_U = ((U_now) > (least_scale) ? U_now : least_scale); /* kept off zero */
        const saturating_bicycle_population_real was_U = ((state->last_U) > (least_scale) ? state->last_U : least_scale);
        const saturating_bicycle_population_real inv_U = (R(1.0)/at_U);
        const saturating_bicycle_population_real inv_L = (R(1.0)/config->L);
        const saturating_bicycle_population_real inv_dt = (R(1.0)/sample->dt);
        const saturating_bicycle_population_real output_scale = at_U*inv_L; /* r = scale x dimensionless */
        const saturating_bicycle_population_real inv_output_scale = config->L*inv_U;
        const saturating_bicycle_population_real span = (sample->dt < config->gap ? sample->dt : R(0.0)); /* [s] the dynamics start anew at the end of a gap */
        const saturating_bicycle_population_real h = at_U*inv_L*span; /* dimensionless time step */
        const saturating_bicycle_population_real ratio_v_star = inv_U*was_U; /* same physical state in the new scales */
        state->v_star = ratio_v_star*state->v_star;
        state->v_star_plain = ratio_v_star*state->v_star_plain;
        const saturating_bicycle_population_real ratio_r_star = inv_U*was_U; /* same physical state in the new scales */
        state->r_star = state->r_star*ratio_r_star;
        state->r_star_plain = state->r_star_plain*ratio_r_star;
        const saturating_bicycle_population_real steer = R(0.5)*state->input_scale*(state->last_input + u_now); /* mean of the sample's two ends */
        const saturating_bicycle_population_real steer_change = state->input_scale*(u_now - state->last_input);
        const saturating_bicycle_population_real u_plain = state->input_offset_plain + steer; /* measured input less its offset [-] */
        const saturating_bicycle_population_real u = state->disturbance + state->input_offset + steer; /* effective input [-] */
        const saturating_bicycle_population_real inv0 = (R(1.0)/state->grip);
        const saturating_bicycle_population_real inv1 = (R(1.0)/state->rho);
        const saturating_bicycle_population_real inv2 = (R(1.0)/(state->pi1 - R(1.0)));
        const saturating_bicycle_population_real s0 = state->v_star + state->pi1*state->r_star;
        const saturating_bicycle_population_real s1 = state->K*inv0*inv2*inv_L;
        const saturating_bicycle_population_real s2 = state->v_star_plain + state->pi1*state->r_star_plain;
        const saturating_bicycle_population_real s3 = state->eta*s1;
        const saturating_bicycle_population_real load0 = s1*(s0 - u); /* force over its limit [-] */
        const saturating_bicycle_population_real load1 = s1*(s2 - u_plain); /* force over its limit [-] */
        const saturating_bicycle_population_real load2 = s3*(s0 - state->r_star); /* force over its limit [-] */
        const saturating_bicycle_population_real load3 = s3*(s2 - state->r_star_plain); /* force over its limit [-] */
        const saturating_bicycle_population_real size0 = (((-load0)) > (load0) ? (-load0) : load0);
        const saturating_bicycle_population_real over0 = R(1.0) + size0*(R(1.0) + R(0.7)*size0);
        const saturating_bicycle_population_real part0 = (R(1.0)/(R(1.0) + over0*size0)); /* force over load */
        const saturating_bicycle_population_real size1 = (((-load1)) > (load1) ? (-load1) : load1);
        const saturating_bicycle_population_real over1 = R(1.0) + size1*(R(1.0) + R(0.7)*size1);
        const saturating_bicycle_population_real part1 = (R(1.0)/(R(1.0) + over1*size1));
        const saturating_bicycle_population_real size2 = (((-load2)) > (load2) ? (-load2) : load2);
        const saturating_bicycle_population_real over2 = R(1.0) + size2*(R(1.0) + R(0.7)*size2);
        const saturating_bicycle_population_real part2 = (R(1.0)/(R(1.0) + over2*size2));
        const saturating_bicycle_population_real size3 = (((-load3)) > (load3) ? (-load3) : load3);
        const saturating_bicycle_population_real over3 = R(1.0) + size3*(R(1.0) + R(0.7)*size3);
        const saturating_bicycle_population_real part3 = (R(1.0)/(R(1.0) + over3*size3));
        const saturating_bicycle_population_real c0 = load0*over0*part0;
        const saturating_bicycle_population_real c1 = load2*over2*part2;
        const saturating_bicycle_population_real c2 = config->L*(inv_U*inv_U);
        const saturating_bicycle_population_real c3 = c2*state->grip;
        const saturating_bicycle_population_real c4 = c3*inv1;
        const saturating_bicycle_population_real c5 = load1*over1*part1;
        const saturating_bicycle_population_real c6 = load3*over3*part3;
        const saturating_bicycle_population_real c7 = c6*state->pi1;
        const saturating_bicycle_population_real c8 = c5 - c6;
        const saturating_bicycle_population_real c9 = c4*c8;
        const saturating_bicycle_population_real c10 = (part0*part0);
        const saturating_bicycle_population_real c11 = R(1.0) + size0*(R(2.0) + R(2.1)*size0);
        const saturating_bicycle_population_real c12 = c10*c11;
        const saturating_bicycle_population_real c13 = state->eta*(part2*part2)*(R(1.0) + size2*(R(2.0) + R(2.1)*size2));
        const saturating_bicycle_population_real c14 = R(0.16666666666666666)*h;
        const saturating_bicycle_population_real c15 = state->K*inv_L;
        const saturating_bicycle_population_real c16 = c15*inv2;
        const saturating_bicycle_population_real c17 = c16*c2;
        const saturating_bicycle_population_real c18 = c13 - c10*c11*inv2*state->pi1;
        const saturating_bicycle_population_real c19 = c15*c2;
        const saturating_bicycle_population_real c20 = c19*state->pi1;
        const saturating_bicycle_population_real c21 = c17*inv1;
        const saturating_bicycle_population_real c22 = c19*inv1;
        const saturating_bicycle_population_real c23 = state->v_star_plain + state->pi1*state->r_star_plain;
        const saturating_bicycle_population_real c24 = c23 - u_plain;
        const saturating_bicycle_population_real c25 = (part1*part1);
        const saturating_bicycle_population_real c26 = R(1.0) + size1*(R(2.0) + R(2.1)*size1);
        const saturating_bicycle_population_real c27 = c25*c26;
        const saturating_bicycle_population_real c28 = c24*c27;
        const saturating_bicycle_population_real c29 = (-state->r_star_plain);
        const saturating_bicycle_population_real c30 = c23 + c29;
        const saturating_bicycle_population_real c31 = state->eta*(part3*part3)*(R(1.0) + size3*(R(2.0) + R(2.1)*size3));
        const saturating_bicycle_population_real c32 = c30*c31;
        const saturating_bicycle_population_real c33 = c28 + c32*state->pi1 - c24*c25*c26*state->pi1;
        const saturating_bicycle_population_real c34 = c32 - c28;
        const saturating_bicycle_population_real c35 = (-c5);
        const saturating_bicycle_population_real c36 = (-c29) - c24*inv2;
        const saturating_bicycle_population_real c37 = c16*inv0;
        const saturating_bicycle_population_real c38 = c30*inv2;
        const saturating_bicycle_population_real c39 = c31*((-c29) - c38);
        const saturating_bicycle_population_real c40 = c31*c38;
        const saturating_bicycle_population_real f_v_star = (-state->r_star) - c3*(load0*over0*part0*state->pi1 - c0 - c1*state->pi1); /* rate [-] */
        const saturating_bicycle_population_real f_r_star = c4*(c0 - c1); /* rate [-] */
        const saturating_bicycle_population_real f_v_star_plain = (-state->r_star_plain) - c3*(load1*over1*part1*state->pi1 - c5 - c7);
        const saturating_bicycle_population_real f_r_star_plain = c9;
        const saturating_bicycle_population_real J_00 = (-c14*c17*(c10*c11*state->pi1 - c12 - c13*state->pi1));
        const saturating_bicycle_population_real J_01 = (-c14*(R(1.0) + c20*((-c18) - c12*inv2)));
        const saturating_bicycle_population_real J_10 = c14*c21*(c12 - c13);
        const saturating_bicycle_population_real J_11 = (-c14*c18*c22);
        const saturating_bicycle_population_real f_v_star_K = c17*c33;
        const saturating_bicycle_population_real f_r_star_K = (-c21*c34);
        const saturating_bicycle_population_real f_v_star_pi1 = (-c3*(state->K*c25*c26*c36*inv0*inv2*inv_L*state->pi1 - c35 - c6 - c27*c36*c37 - c37*c39*state->pi1));
        const saturating_bicycle_population_real f_r_star_pi1 = c21*(c25*c26*c36 - c39);
        const saturating_bicycle_population_real f_v_star_eta = c20*c40;
        const saturating_bicycle_population_real f_r_star_eta = (-c22*c40);
        const saturating_bicycle_population_real f_v_star_rho = R(0.0);
        const saturating_bicycle_population_real f_r_star_rho = (-c9);
        const saturating_bicycle_population_real f_v_star_grip = (-c3*(c35 + c33*c37 + c5*state->pi1 - c7));
        const saturating_bicycle_population_real f_r_star_grip = c4*(c8 + c34*c37);
        const saturating_bicycle_population_real f_v_star_u = (-c17*c27*(R(1.0) - state->pi1));
        const saturating_bicycle_population_real f_r_star_u = (-c21*c27);
        const saturating_bicycle_population_real p0 = J_00*J_11 - J_01*J_10;
        const saturating_bicycle_population_real p1 = (-J_00) - J_11;
        const saturating_bicycle_population_real n0 = R(1.0) - R(1.5)*p0;
        const saturating_bicycle_population_real n1 = (-R(2.0)) - R(1.5)*p1;
        const saturating_bicycle_population_real i_det = (R(1.0)/((n0*n0) + p0*(n1*n1) - n0*n1*p1)); /* det N > 0 for every real J */
        const saturating_bicycle_population_real i0 = i_det*(n0 - n1*p1);
        const saturating_bicycle_population_real i1 = (-i_det*n1);
        const saturating_bicycle_population_real E0 = i0 - i1*p0; /* half a step */
        const saturating_bicycle_population_real E1 = i0 + i1 - i1*p1;
        const saturating_bicycle_population_real H0 = R(0.5)*h*i0 + R(0.25)*h*i1*p0; /* change per rate over half a step */
        const saturating_bicycle_population_real H1 = R(0.5)*h*i1 + R(0.25)*h*i1*p1 - R(0.25)*h*i0;
        const saturating_bicycle_population_real m0 = (E0*E0) - p0*(E1*E1);
        const saturating_bicycle_population_real m1 = R(2.0)*E0*E1 - p1*(E1*E1);
        const saturating_bicycle_population_real g0 = H0*(R(1.0) + E0) - E1*H1*p0;
        const saturating_bicycle_population_real g1 = E1*H0 + H1*(R(1.0) + E0) - E1*H1*p1;
        const saturating_bicycle_population_real wi0 = (-p0*(R(0.4375) + R(0.1875)*p1));
        const saturating_bicycle_population_real wi1 = R(0.1875)*p0 - R(0.5) - p1*(R(0.4375) + R(0.1875)*p1);
        const saturating_bicycle_population_real wh0 = i0*wi0 - i1*p0*wi1;
        const saturating_bicycle_population_real wh1 = i0*wi1 + i1*wi0 - i1*p1*wi1;
        const saturating_bicycle_population_real w0 = i0*wh0 - i1*p0*wh1; /* W/h in powers of J */
        const saturating_bicycle_population_real w1 = i0*wh1 + i1*wh0 - i1*p1*wh1;
        const saturating_bicycle_population_real M_00 = m0 + J_00*m1; /* dx+/dx */
        const saturating_bicycle_population_real M_01 = J_01*m1;
        const saturating_bicycle_population_real M_10 = J_10*m1;
        const saturating_bicycle_population_real M_11 = m0 + J_11*m1;
        const saturating_bicycle_population_real G_00 = g0 + J_00*g1; /* change per rate */
        const saturating_bicycle_population_real G_01 = J_01*g1;
        const saturating_bicycle_population_real G_10 = J_10*g1;
        const saturating_bicycle_population_real G_11 = g0 + J_11*g1;
        const saturating_bicycle_population_real ramp = h*steer_change;
        const saturating_bicycle_population_real ramp_0 = ramp*w0;
        const saturating_bicycle_population_real ramp_1 = ramp*w1;
        const saturating_bicycle_population_real slope1_v_star = J_00*f_v_star_u + J_01*f_r_star_u;
        const saturating_bicycle_population_real slope1_r_star = J_10*f_v_star_u + J_11*f_r_star_u;
        const saturating_bicycle_population_real rise_v_star = f_v_star_u*ramp_0 + ramp_1*slope1_v_star; /* the input rises or falls in a straight line [-] */
        const saturating_bicycle_population_real rise_r_star = f_r_star_u*ramp_0 + ramp_1*slope1_r_star;
        const saturating_bicycle_population_real d_v_star = rise_v_star + G_00*f_v_star + G_01*f_r_star; /* change over the step [-] */
        const saturating_bicycle_population_real d_r_star = rise_r_star + G_10*f_v_star + G_11*f_r_star; /* change over the step [-] */
        const saturating_bicycle_population_real d_v_star_plain = rise_v_star + G_00*f_v_star_plain + G_01*f_r_star_plain;
        const saturating_bicycle_population_real d_r_star_plain = rise_r_star + G_10*f_v_star_plain + G_11*f_r_star_plain;
        const saturating_bicycle_population_real F_v_star_K = G_00*f_v_star_K + G_01*f_r_star_K;
        const saturating_bicycle_population_real F_r_star_K = G_10*f_v_star_K + G_11*f_r_star_K;
        const saturating_bicycle_population_real F_v_star_pi1 = G_00*f_v_star_pi1 + G_01*f_r_star_pi1;
        const saturating_bicycle_population_real F_r_star_pi1 = G_10*f_v_star_pi1 + G_11*f_r_star_pi1;
        const saturating_bicycle_population_real F_v_star_eta = G_00*f_v_star_eta + G_01*f_r_star_eta;
        const saturating_bicycle_population_real F_r_star_eta = G_10*f_v_star_eta + G_11*f_r_star_eta;
        const saturating_bicycle_population_real F_v_star_rho = G_00*f_v_star_rho + G_01*f_r_star_rho;
        const saturating_bicycle_population_real F_r_star_rho = G_10*f_v_star_rho + G_11*f_r_star_rho;
        const saturating_bicycle_population_real F_v_star_grip = G_00*f_v_star_grip + G_01*f_r_star_grip;
        const saturating_bicycle_population_real F_r_star_grip = G_10*f_v_star_grip + G_11*f_r_star_grip;
        const saturating_bicycle_population_real F_v_star_u = G_00*f_v_star_u + G_01*f_r_star_u;
        const saturating_bicycle_population_real F_r_star_u = G_10*f_v_star_u + G_11*f_r_star_u;
        const saturating_bicycle_population_real keep_w = ((R(0.0)) > (R(1.0) - config->disturbance_rate*sample->dt) ? R(0.0) : R(1.0) - config->disturbance_rate*sample->dt);
        const saturating_bicycle_population_real w_nominal = (config->disturbance_floor*config->disturbance_floor) + state->activity*(config->disturbance_share*config->disturbance_share)*(inv_output_scale*inv_output_scale); /* nominal variance of the disturbance */
        move = R(0.0);
        diffusion = config->drift + config->faint_drift*((R(0.0)) > (R(1.0) - state->heard*config->inv_telling) ? R(0.0) : R(1.0) - state->heard*config->inv_telling); /* a jump that could not have shown may have come */
        if (state->excited < R(0.5)) { /* nothing heard: it may have changed, and the population is the best guess */
            const saturating_bicycle_population_real lost = ((R(1.0)) < (R(0.5)*sample->dt*config->idle_drift*config->prior_information) ? R(1.0) : R(0.5)*sample->dt*config->idle_drift*config->prior_information);
            const saturating_bicycle_population_real keep = R(1.0) - lost;
            diffusion = lost*(R(1.0) + keep)/(sample->dt*config->prior_information); /* for long: the prior variance */
            P[3] = P[3]*keep;
            P[13] = P[13]*keep;
            P[22] = P[22]*keep;
            P[30] = P[30]*keep;
            P[31] = P[31]*keep;
            P[32] = P[32]*keep;
            P[33] = P[33]*keep;
            P[34] = P[34]*keep;
            P[35] = P[35]*keep;
            P[36] = P[36]*keep;
            P[37] = P[37]*keep;
            P[30] = P[30]*keep;
            const saturating_bicycle_population_real p = state->K - config->K_prior;
            const saturating_bicycle_population_real q = state->K + config->K_prior;
            const saturating_bicycle_population_real pp = (p*p);
            const saturating_bicycle_population_real qq = (q*q);
            const saturating_bicycle_population_real away = R(2.0)*p*(R(15.0)*qq - R(4.0)*pp)/(q*(R(15.0)*qq - R(9.0)*pp)); /* ln(K/K_prior) */
            move = (-away*lost);
        }
        const saturating_bicycle_population_real F_v_star_v_star = M_00*ratio_v_star;
        const saturating_bicycle_population_real F_v_star_r_star = M_01*ratio_r_star;
        const saturating_bicycle_population_real F_r_star_v_star = M_10*ratio_v_star;
        const saturating_bicycle_population_real F_r_star_r_star = M_11*ratio_r_star;
        saturating_bicycle_population_propagate(config, state, sample, steer, F_v_star_K, F_v_star_eta, F_v_star_grip, F_v_star_pi1, F_v_star_r_star, F_v_star_rho, F_v_star_u, F_v_star_v_star, F_r_star_K, F_r_star_eta, F_r_star_grip, F_r_star_pi1, F_r_star_r_star, F_r_star_rho, F_r_star_u, F_r_star_v_star, keep_w, w_nominal, diffusion);
        state->disturbance = state->disturbance*keep_w;
        state->v_star = d_v_star + state->v_star;
        state->r_star = d_r_star + state->r_star;
        const saturating_bicycle_population_real follow = ((R(1.0)) < (config->companion_rate*sample->dt) ? R(1.0) : config->companion_rate*sample->dt);
        state->input_offset_plain = state->input_offset_plain + (state->input_offset - state->input_offset_plain)*((R(1.0)) < (sample->dt*config->offset_rate) ? R(1.0) : sample->dt*config->offset_rate);
        state->v_star_plain = d_v_star_plain + state->v_star_plain + follow*(state->v_star - d_v_star_plain - state->v_star_plain);
        state->r_star_plain = d_r_star_plain + state->r_star_plain + follow*(state->r_star - d_r_star_plain - state->r_star_plain);
        const saturating_bicycle_population_real response = output_scale*state->r_star; /* output of the model */
        predicted = state->output_bias + response;
        const saturating_bicycle_population_real output_rate = d_r_star*inv_dt*output_scale;
        state->activity = state->activity + ((response*response) - state->activity)*((R(1.0)) < (config->activity_rate*sample->dt) ? R(1.0) : config->activity_rate*sample->dt);
        const saturating_bicycle_population_real noise = state->noise_scale*(config->noise_variance + (output_rate*output_rate)*(config->timing_error*config->timing_error) + state->activity*(config->structure_share*config->structure_share)*((R(1.0)) > (R(2.0)*inv_dt*config->structure_time) ? R(1.0) : R(2.0)*inv_dt*config->structure_time)); /* variance of the measurement */
        const saturating_bicycle_population_real validity_now = inv_L*state->r_star*(at_U*at_U); /* lateral acceleration */
        const saturating_bicycle_population_real validity_then = state->validity*(R(1.0) - ((R(1.0)) < (sample->dt*config->validity_rate) ? R(1.0) : sample->dt*config->validity_rate));
        const saturating_bicycle_population_real validity_square = (validity_now*validity_now);
        state->validity = ((validity_square) > (validity_then) ? validity_square : validity_then);
        if (usable > 0) { /* measurement */
            const saturating_bicycle_population_real c_1 = P[20] + P[11]*output_scale;
            const saturating_bicycle_population_real c_3 = P[37] + P[13]*output_scale;
            const saturating_bicycle_population_real c_10 = P[65] + P[20]*output_scale;
            innovation = sample->measured - predicted;
            innovation_variance = c_10 + noise + c_1*output_scale;
            inv_spread = (R(1.0)/innovation_variance);
            const saturating_bicycle_population_real nis = inv_spread*(innovation*innovation); /* normalised innovation squared */
            if (nis > config->outlier_ratio) { /* an outlier counts for less */
                inv_spread = inv_spread*config->outlier_ratio/nis;
            }
            const saturating_bicycle_population_real inv_P = (R(1.0)/P[30]);
            const saturating_bicycle_population_real sensitivity = c_3*inv_P; /* of the output to ln K */
            state->excitation = state->excitation + ((sensitivity*sensitivity) - state->excitation)*((R(1.0)) < (sample->dt*config->excitation_rate) ? R(1.0) : sample->dt*config->excitation_rate);
            state->excited = (state->excitation > config->excitation_ratio*noise ? R(1.0) : R(0.0));
            const saturating_bicycle_population_real linear = (state->validity < (config->validity_limit*config->validity_limit) ? R(1.0) : R(0.0)); /* 1 in the model's linear range */
            const saturating_bicycle_population_real odd = ((R(9.0)) < (nis) ? R(9.0) : nis) - R(1.0); /* by how much it is not as expected */
            state->surprise = state->surprise + (R(1.0) + linear*odd - state->surprise)*((R(1.0)) < (sample->dt*config->surprise_rate) ? R(1.0) : sample->dt*config->surprise_rate); /* recent mean of the normalised innovation squared */
            const saturating_bicycle_population_real learn_beyond = state->excited*inv_spread;
            state->untaught = sample->dt + state->untaught;
            const saturating_bicycle_population_real learn = ((config->beyond_time <= state->untaught) || (linear > R(0.5)) ? state->excited*inv_spread : R(0.0)); /* its error there lasts */
            if (learn > R(0.0)) {
                state->untaught = R(0.0);
            }
            state->heard = state->heard*(R(1.0) - ((R(1.0)) < (sample->dt*config->heard_rate) ? R(1.0) : sample->dt*config->heard_rate)) + inv_spread*(sensitivity*sensitivity); /* information of late */
            const saturating_bicycle_population_real above = state->surprise - R(1.0);
            state->restlessness = state->restlessness + ((above*above) - state->restlessness)*((R(1.0)) < (sample->dt*config->noise_adapt) ? R(1.0) : sample->dt*config->noise_adapt);
            const saturating_bicycle_population_real rise = ((above*above) > config->jump_ratio*state->restlessness ? state->surprise - config->surprise_limit : R(0.0));
            state->jump = ((R(0.0)) > (rise) ? R(0.0) : rise);
            const saturating_bicycle_population_real learn_slow = (state->jump <= R(0.0) ? learn : R(0.0)); /* a jump is not blamed on what cannot jump */
            state->unlearnt = sample->dt + state->unlearnt;
            const saturating_bicycle_population_real learn_seldom = (config->seldom <= state->unlearnt ? learn_slow : R(0.0)); /* the next sample tells little that this one does not */
            if (learn_seldom > R(0.0)) {
                state->unlearnt = R(0.0);
            }
            const saturating_bicycle_population_real gain_3 = c_3*learn;
            const saturating_bicycle_population_real gained = c_3*gain_3*inv_P; /* share of the variance removed */
            state->information = state->information + gained*inv_P*(R(1.0) + gained); /* 1/variance gained */
            move = move + gain_3*innovation;
            saturating_bicycle_population_correct(state, output_scale, inv_spread, c_1, learn_seldom, learn_slow, learn_beyond, c_10, c_3, gain_3, innovation);
            state->settling = ((config->noise_adapt) > (state->settling - sample->dt*(state->settling*state->settling)) ? config->noise_adapt : state->settling - sample->dt*(state->settling*state->settling)); /* 1/time at first */
            const saturating_bicycle_population_real noise_change = odd*((R(0.05)) < (sample->dt*state->settling) ? R(0.05) : sample->dt*state->settling);
            state->noise_scale = state->noise_scale*(R(1.0) + noise_change*(R(1.0) + noise_change*(R(0.5) + R(0.16666666666666666)*noise_change)));
            state->noise_scale = ((state->noise_scale) > (config->noise_scale_low) ? state->noise_scale : config->noise_scale_low);
            state->noise_scale = ((state->noise_scale) < (config->noise_scale_high) ? state->noise_scale : config->noise_scale_high);
            const saturating_bicycle_population_real expected = state->disturbance_scale*w_nominal; /* disturbance variance expected */
            const saturating_bicycle_population_real seen = ((R(9.0)*expected) < (P[21] + (state->disturbance*state->disturbance)) ? R(9.0)*expected : P[21] + (state->disturbance*state->disturbance)); /* and seen */
            const saturating_bicycle_population_real unseen = ((expected*config->observed_least) > (expected - P[21]) ? expected*config->observed_least : expected - P[21]);
            state->disturbance_scale = state->disturbance_scale + state->disturbance_scale*(seen - expected)*((R(1.0)) < (config->disturbance_adapt*sample->dt) ? R(1.0) : config->disturbance_adapt*sample->dt)/unseen;
            state->disturbance_scale = ((state->disturbance_scale) > (config->disturbance_scale_low) ? state->disturbance_scale : config->disturbance_scale_low);
            state->disturbance_scale = ((state->disturbance_scale) < (config->disturbance_scale_high) ? state->disturbance_scale : config->disturbance_scale_high);
            if ((state->excited < R(0.5)) && (status < 1)) {
                status = 1;
            }
            if ((state->validity > (config->validity_limit*config->validity_limit)) && (status < 2)) {
                status = 2;
            }
        }
        const saturating_bicycle_population_real above_move = (((-R(1.0))) > (move) ? (-R(1.0)) : move);
        const saturating_bicycle_population_real bounded_move = ((R(1.0)) < (above_move) ? R(1.0) : above_move);
        state->K = state->K*(R(1.0) + bounded_move*(R(1.0) + bounded_move*(R(0.5) + R(0.16666666666666666)*bounded_move)));
        if ((state->K < config->K_low) || (state->K > config->K_high) || (state->eta < config->eta_low) || (state->eta > config->eta_high) || (state->grip < config->grip_low) || (state->grip > config->grip_high) || (state->input_scale < config->input_scale_low) || (state->input_scale > config->input_scale_high) || (state->pi1 < config->pi1_low) || (state->pi1 > config->pi1_high) || (state->rho < config->rho_low) || (state->rho > config->rho_high)) { /* prior +- its allowed range */
            state->K = ((config->K_high) < (((state->K) > (config->K_low) ? state->K : config->K_low)) ? config->K_high : ((state->K) > (config->K_low) ? state->K : config->K_low));
            state->pi1 = ((config->pi1_high) < (((state->pi1) > (config->pi1_low) ? state->pi1 : config->pi1_low)) ? config->pi1_high : ((state->pi1) > (config->pi1_low) ? state->pi1 : config->pi1_low));
            state->eta = ((config->eta_high) < (((state->eta) > (config->eta_low) ? state->eta : config->eta_low)) ? config->eta_high : ((state->eta) > (config->eta_low) ? state->eta : config->eta_low));
            state->rho = ((config->rho_high) < (((state->rho) > (config->rho_low) ? state->rho : config->rho_low)) ? config->rho_high : ((state->rho) > (config->rho_low) ? state->rho : config->rho_low));
            state->grip = ((config->grip_high) < (((state->grip) > (config->grip_low) ? state->grip : config->grip_low)) ? config->grip_high : ((state->grip) > (config->grip_low) ? state->grip : config->grip_low));
            state->input_scale = ((config->input_scale_high) < (((state->input_scale) > (config->input_scale_low) ? state->input_scale : config->input_scale_low)) ? config->input_scale_high : ((state->input_scale) > (config->input_scale_low) ? state->input_scale : config->input_scale_low));
            if (usable > 0) {
                status = 3;
            }
        }
        noise_now = noise;
        disturbance_now = state->disturbance_scale*w_nominal;
        state->last_input = u_now;
        state->last_U = U_now;
        if (usable > 0) {
            state->age = R(0.0);
            state->started = R(1.0);
        }
    } else {
        status = 7;
        state->age = (sample->dt > R(1.0) ? R(1000000.0) : state->age); /* an endless pause is a gap for the next sample */
    }
    estimate = state->K;
    own_variance = P[30];
    const saturating_bicycle_population_real pivot_5 = P[45];
    const saturating_bicycle_population_real inv_pivot_5 = (R(1.0)/((pivot_5) > (R(1e-24) + R(1e-06)*P[45]) ? pivot_5 : R(1e-24) + R(1e-06)*P[45]));
    const saturating_bicycle_population_real lean_5 = P[32];
    const saturating_bicycle_population_real row_5_6 = P[46];
    const saturating_bicycle_population_real ratio_5_6 = inv_pivot_5*row_5_6;
    const saturating_bicycle_population_real row_5_7 = P[47];
    const saturating_bicycle_population_real ratio_5_7 = inv_pivot_5*row_5_7;
    const saturating_bicycle_population_real row_5_8 = P[48];
    const saturating_bicycle_population_real ratio_5_8 = inv_pivot_5*row_5_8;
    const saturating_bicycle_population_real pivot_6 = P[51] - ratio_5_6*row_5_6;
    const saturating_bicycle_population_real inv_pivot_6 = (R(1.0)/((pivot_6) > (R(1e-24) + R(1e-06)*P[51]) ? pivot_6 : R(1e-24) + R(1e-06)*P[51]));
    const saturating_bicycle_population_real lean_6 = P[33] - lean_5*ratio_5_6;
    const saturating_bicycle_population_real row_6_7 = P[52] - ratio_5_6*row_5_7;
    const saturating_bicycle_population_real ratio_6_7 = inv_pivot_6*row_6_7;
    const saturating_bicycle_population_real row_6_8 = P[53] - ratio_5_6*row_5_8;
    const saturating_bicycle_population_real ratio_6_8 = inv_pivot_6*row_6_8;
    const saturating_bicycle_population_real pivot_7 = P[56] - ratio_5_7*row_5_7 - ratio_6_7*row_6_7;
    const saturating_bicycle_population_real inv_pivot_7 = (R(1.0)/((pivot_7) > (R(1e-24) + R(1e-06)*P[56]) ? pivot_7 : R(1e-24) + R(1e-06)*P[56]));
    const saturating_bicycle_population_real lean_7 = P[34] - lean_5*ratio_5_7 - lean_6*ratio_6_7;
    const saturating_bicycle_population_real row_7_8 = P[57] - ratio_5_7*row_5_8 - ratio_6_7*row_6_8;
    const saturating_bicycle_population_real ratio_7_8 = inv_pivot_7*row_7_8;
    const saturating_bicycle_population_real pivot_8 = P[60] - ratio_5_8*row_5_8 - ratio_6_8*row_6_8 - ratio_7_8*row_7_8;
    const saturating_bicycle_population_real inv_pivot_8 = (R(1.0)/((pivot_8) > (R(1e-24) + R(1e-06)*P[60]) ? pivot_8 : R(1e-24) + R(1e-06)*P[60]));
    const saturating_bicycle_population_real lean_8 = P[35] - lean_5*ratio_5_8 - lean_6*ratio_6_8 - lean_7*ratio_7_8;
    const saturating_bicycle_population_real leant = inv_pivot_5*(lean_5*lean_5) + inv_pivot_6*(lean_6*lean_6) + inv_pivot_7*(lean_7*lean_7) + inv_pivot_8*(lean_8*lean_8); /* of it, what would go if the constants were known */
    variance = P[30] + config->slow_doubt*((P[30]) < (leant) ? P[30] : leant);
    information_gained = state->information;
    pi1_now = state->pi1;
    eta_now = state->eta;
    rho_now = state->rho;
    grip_now = state->grip;
    offset_now = state->input_offset;
    bias_now = state->output_bias;

    output->estimate = estimate;
    output->variance = variance;
    output->predicted = predicted;
    output->innovation = innovation;
    output->innovation_variance = innovation_variance;
    output->information_gained = information_gained;
    output->own_variance = own_variance;
    output->pi1_now = pi1_now;
    output->eta_now = eta_now;
    output->rho_now = rho_now;
    output->grip_now = grip_now;
    output->offset_now = offset_now;
    output->bias_now = bias_now;
    output->noise_now = noise_now;
    output->disturbance_now = disturbance_now;
    return status;
}

/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int saturating_bicycle_population_step(const saturating_bicycle_population_config *config, saturating_bicycle_population_state *state,
                               const saturating_bicycle_population_sample *sample, saturating_bicycle_population_output *output)
{
    return saturating_bicycle_population_advance(config, state, sample, output);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long saturating_bicycle_population_batch(const saturating_bicycle_population_config *config, saturating_bicycle_population_state *state, long n,
                                 const saturating_bicycle_population_sample *samples, saturating_bicycle_population_output *outputs, int *status)
{
    saturating_bicycle_population_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = saturating_bicycle_population_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}
