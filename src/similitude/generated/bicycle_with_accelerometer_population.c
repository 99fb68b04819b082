/* Population filter of the bicycle_with_accelerometer. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle_with_accelerometer, Brennan & Alleyne 2004, eqs 1-4, with saturating tyres
 *   base: m, L, U
 *   unknowns: K, pi1, eta, rho, grip, place
 *   coordinates: v_star, r_star, disturbance, K, pi1, eta, rho, grip, place, input_scale, input_offset, output_bias, ay_bias
 *
 * Operations: step 2598 at most, 130 at least (arithmetic, comparisons, selects), init 8.
 * Memory: state 127 reals, configuration 96 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL bicycle_with_accelerometer_population_real;
#define R(x) ((bicycle_with_accelerometer_population_real)(x))

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

enum bicycle_with_accelerometer_population_status {
    BICYCLE_WITH_ACCELEROMETER_POPULATION_OK = 0,
    BICYCLE_WITH_ACCELEROMETER_POPULATION_NOT_EXCITED = 1,
    BICYCLE_WITH_ACCELEROMETER_POPULATION_OUTSIDE_LINEAR = 2,
    BICYCLE_WITH_ACCELEROMETER_POPULATION_AT_LIMIT = 3,
    BICYCLE_WITH_ACCELEROMETER_POPULATION_NO_MEASUREMENT = 4,
    BICYCLE_WITH_ACCELEROMETER_POPULATION_RESTARTED = 5,
    BICYCLE_WITH_ACCELEROMETER_POPULATION_TOO_SLOW = 6,
    BICYCLE_WITH_ACCELEROMETER_POPULATION_BAD_SAMPLE = 7
};

typedef struct bicycle_with_accelerometer_population_config {
    bicycle_with_accelerometer_population_real L;    /* [m] wheelbase */
    bicycle_with_accelerometer_population_real K_prior; /* [m^2/s^2] prior of Caf L/m, front cornering stiffness per mass and length */
    bicycle_with_accelerometer_population_real pi1_prior; /* [-] prior of a/L, position of the centre of gravity */
    bicycle_with_accelerometer_population_real eta_prior; /* [-] prior of rear over front cornering coefficient; > 1 understeers */
    bicycle_with_accelerometer_population_real rho_prior; /* [-] prior of Iz/(m a b), yaw inertia ratio */
    bicycle_with_accelerometer_population_real grip_prior; /* [m/s^2] prior of mu g, greatest lateral acceleration */
    bicycle_with_accelerometer_population_real place_prior; /* [-] prior of accelerometer behind the front axle over L */
    bicycle_with_accelerometer_population_real P_prior[21]; /* [-] prior covariance of the unknowns' coordinates, upper triangle */
    bicycle_with_accelerometer_population_real prior_information; /* [-] 1/prior variance of ln K */
    bicycle_with_accelerometer_population_real K_low; /* [m^2/s^2] lowest value the population allows */
    bicycle_with_accelerometer_population_real K_high; /* [m^2/s^2] highest value the population allows */
    bicycle_with_accelerometer_population_real pi1_low; /* [-] lowest value the population allows */
    bicycle_with_accelerometer_population_real pi1_high; /* [-] highest value the population allows */
    bicycle_with_accelerometer_population_real eta_low; /* [-] lowest value the population allows */
    bicycle_with_accelerometer_population_real eta_high; /* [-] highest value the population allows */
    bicycle_with_accelerometer_population_real rho_low; /* [-] lowest value the population allows */
    bicycle_with_accelerometer_population_real rho_high; /* [-] highest value the population allows */
    bicycle_with_accelerometer_population_real grip_low; /* [m/s^2] lowest value the population allows */
    bicycle_with_accelerometer_population_real grip_high; /* [m/s^2] highest value the population allows */
    bicycle_with_accelerometer_population_real place_low; /* [-] lowest value the population allows */
    bicycle_with_accelerometer_population_real place_high; /* [-] highest value the population allows */
    bicycle_with_accelerometer_population_real input_scale_sd; /* [-] sd of the scale of delta, also that of the known scales */
    bicycle_with_accelerometer_population_real input_scale_low; /* [-] least scale of delta */
    bicycle_with_accelerometer_population_real input_scale_high; /* [-] greatest scale of delta */
    bicycle_with_accelerometer_population_real input_offset_sd; /* [rad] prior sd of the offset of delta */
    bicycle_with_accelerometer_population_real output_bias_sd; /* [rad/s] prior sd of the bias of r */
    bicycle_with_accelerometer_population_real v_star_sd; /* [-] sd after a restart */
    bicycle_with_accelerometer_population_real r_star_sd; /* [-] sd after a restart */
    bicycle_with_accelerometer_population_real noise_variance; /* [(rad/s)^2] white noise of r a sample */
    bicycle_with_accelerometer_population_real drift; /* [1/s] diffusion of ln K while it is observed */
    bicycle_with_accelerometer_population_real idle_drift; /* [1/s] diffusion of ln K while nothing is heard of it */
    bicycle_with_accelerometer_population_real jump_drift; /* [1/s] further diffusion per unit of surprise above its limit */
    bicycle_with_accelerometer_population_real bias_drift; /* [(rad/s)^2/s] random walk of the output bias */
    bicycle_with_accelerometer_population_real timing_error; /* [s] timing error between input and output */
    bicycle_with_accelerometer_population_real companion_rate; /* [1/s] rate at which the uncorrected states follow the estimate */
    bicycle_with_accelerometer_population_real offset_rate; /* [1/s] rate at which the uncorrected states' offset follows the estimate */
    bicycle_with_accelerometer_population_real structure_share; /* [-] structural error as a share of the output's activity */
    bicycle_with_accelerometer_population_real structure_time; /* [s] correlation time of the structural error */
    bicycle_with_accelerometer_population_real activity_rate; /* [1/s] averaging rate of the output's activity */
    bicycle_with_accelerometer_population_real disturbance_floor; /* [rad] disturbance at rest, equivalent input */
    bicycle_with_accelerometer_population_real disturbance_share; /* [-] disturbance as a share of the dimensionless activity */
    bicycle_with_accelerometer_population_real disturbance_rate; /* [1/s] 1/correlation time of the disturbance */
    bicycle_with_accelerometer_population_real disturbance_adapt; /* [1/s] adaptation rate of the disturbance's size */
    bicycle_with_accelerometer_population_real disturbance_scale_start; /* [-] disturbance variance against nominal at the start */
    bicycle_with_accelerometer_population_real disturbance_scale_low; /* [-] least disturbance variance against nominal */
    bicycle_with_accelerometer_population_real disturbance_scale_high; /* [-] greatest disturbance variance against nominal */
    bicycle_with_accelerometer_population_real noise_adapt; /* [1/s] adaptation rate of the noise's size in the long run */
    bicycle_with_accelerometer_population_real noise_scale_low; /* [-] least noise variance against nominal */
    bicycle_with_accelerometer_population_real noise_scale_high; /* [-] greatest noise variance against nominal */
    bicycle_with_accelerometer_population_real excitation_ratio; /* [-] least variance of sensitivity against noise to learn from */
    bicycle_with_accelerometer_population_real excitation_rate; /* [1/s] averaging rate of the excitation */
    bicycle_with_accelerometer_population_real seldom; /* [s] least time between samples that the seldom learnt unknowns learn from */
    bicycle_with_accelerometer_population_real beyond_time; /* [s] beyond the linear range all but grip learn so seldom */
    bicycle_with_accelerometer_population_real slow_doubt; /* [-] share of ln K's variance from learnt constants that is added to it */
    bicycle_with_accelerometer_population_real surprise_rate; /* [1/s] averaging rate of the normalised innovation */
    bicycle_with_accelerometer_population_real jump_ratio; /* [-] squared surprise against its long-run mean that speaks of a jump */
    bicycle_with_accelerometer_population_real surprise_limit; /* [-] mean squared normalised innovation that speaks of a jump */
    bicycle_with_accelerometer_population_real heard_rate; /* [1/s] rate at which what was told of the first unknown is forgotten */
    bicycle_with_accelerometer_population_real faint_drift; /* [1/s] further diffusion of ln K while a jump could not show */
    bicycle_with_accelerometer_population_real inv_telling; /* [-] 1/information of late in which a jump shows */
    bicycle_with_accelerometer_population_real observed_least; /* [-] least share of the disturbance taken as observed */
    bicycle_with_accelerometer_population_real outlier_ratio; /* [-] squared innovation over its variance beyond which it is bounded */
    bicycle_with_accelerometer_population_real gap;  /* [s] longest time without a usable sample before a restart */
    bicycle_with_accelerometer_population_real input_limit; /* [rad] greatest believable delta */
    bicycle_with_accelerometer_population_real output_limit; /* [rad/s] greatest believable r */
    bicycle_with_accelerometer_population_real signal_limit; /* [m/s] greatest believable scale */
    bicycle_with_accelerometer_population_real validity_limit; /* [m/s^2] edge of the model's linear range */
    bicycle_with_accelerometer_population_real validity_rate; /* [1/s] decay rate of the memory of a visit outside the linear range */
    bicycle_with_accelerometer_population_real ay_bias_sd; /* [m/s^2] prior sd of the bias of ay */
    bicycle_with_accelerometer_population_real ay_bias_drift; /* [(m/s^2)^2/s] random walk of the bias of ay */
    bicycle_with_accelerometer_population_real ay_variance; /* [(m/s^2)^2] white noise of ay a sample */
    bicycle_with_accelerometer_population_real ay_share; /* [-] structural error of ay as a share of it */
    bicycle_with_accelerometer_population_real ay_time; /* [s] correlation time of what ay holds besides the model */
    bicycle_with_accelerometer_population_real ay_noise_scale_low; /* [-] least noise variance of ay against nominal */
    bicycle_with_accelerometer_population_real ay_noise_scale_high; /* [-] greatest noise variance of ay against nominal */
    bicycle_with_accelerometer_population_real ay_limit; /* [m/s^2] greatest believable ay */
} bicycle_with_accelerometer_population_config;

typedef struct bicycle_with_accelerometer_population_state {
    bicycle_with_accelerometer_population_real v_star; /* [-] dimensionless state */
    bicycle_with_accelerometer_population_real r_star; /* [-] dimensionless state */
    bicycle_with_accelerometer_population_real v_star_plain; /* [-] the same, not corrected by measurements */
    bicycle_with_accelerometer_population_real r_star_plain; /* [-] the same, not corrected by measurements */
    bicycle_with_accelerometer_population_real input_offset_plain; /* [rad] its offset: the estimated one, followed slowly */
    bicycle_with_accelerometer_population_real disturbance; /* [rad] disturbance as an equivalent delta */
    bicycle_with_accelerometer_population_real K;    /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_with_accelerometer_population_real pi1;  /* [-] a/L, position of the centre of gravity */
    bicycle_with_accelerometer_population_real eta;  /* [-] rear over front cornering coefficient; > 1 understeers */
    bicycle_with_accelerometer_population_real rho;  /* [-] Iz/(m a b), yaw inertia ratio */
    bicycle_with_accelerometer_population_real grip; /* [m/s^2] mu g, greatest lateral acceleration */
    bicycle_with_accelerometer_population_real place; /* [-] accelerometer behind the front axle over L */
    bicycle_with_accelerometer_population_real input_scale; /* [-] delta that acts over delta measured */
    bicycle_with_accelerometer_population_real input_offset; /* [rad] offset of delta */
    bicycle_with_accelerometer_population_real output_bias; /* [rad/s] bias of r */
    bicycle_with_accelerometer_population_real ay_bias; /* [m/s^2] bias of ay */
    bicycle_with_accelerometer_population_real ay_activity; /* [(m/s^2)^2] mean square of ay predicted */
    bicycle_with_accelerometer_population_real ay_noise_scale; /* [-] noise variance of ay against nominal */
    bicycle_with_accelerometer_population_real P[91]; /* [-] covariance of the coordinates above, upper triangle by rows */
    bicycle_with_accelerometer_population_real noise_scale; /* [-] noise variance against nominal */
    bicycle_with_accelerometer_population_real disturbance_scale; /* [-] disturbance variance against nominal */
    bicycle_with_accelerometer_population_real activity; /* [(rad/s)^2] mean square of the predicted output */
    bicycle_with_accelerometer_population_real settling; /* [1/s] adaptation rate of the noise's size now, fast at first */
    bicycle_with_accelerometer_population_real restlessness; /* [-] long-run mean square of the surprise beyond one */
    bicycle_with_accelerometer_population_real jump; /* [-] surprise taken as a jump of the first unknown */
    bicycle_with_accelerometer_population_real surprise; /* [-] recent mean of the normalised innovation squared */
    bicycle_with_accelerometer_population_real heard; /* [-] recent information about the first unknown */
    bicycle_with_accelerometer_population_real excitation; /* [(rad/s)^2] mean square sensitivity to the first unknown */
    bicycle_with_accelerometer_population_real excited; /* [-] 1 while the input excites the first unknown, else 0 */
    bicycle_with_accelerometer_population_real unlearnt; /* [s] time since the seldom learnt unknowns last learnt anything */
    bicycle_with_accelerometer_population_real untaught; /* [s] time since a sample last taught more than grip */
    bicycle_with_accelerometer_population_real validity; /* [(m/s^2)^2] recent peak of the validity signal, squared */
    bicycle_with_accelerometer_population_real information; /* [-] information gained about ln K */
    bicycle_with_accelerometer_population_real last_input; /* [rad] input of the sample before */
    bicycle_with_accelerometer_population_real last_U; /* [m/s] forward speed of the sample before */
    bicycle_with_accelerometer_population_real age;  /* [s] time since the last usable sample */
    bicycle_with_accelerometer_population_real started; /* [-] 1 once a sample was used; 0 again while the scales hide the dynamics */
} bicycle_with_accelerometer_population_state;

typedef struct bicycle_with_accelerometer_population_sample {
    bicycle_with_accelerometer_population_real dt;   /* [s] time since the sample before */
    bicycle_with_accelerometer_population_real input; /* [rad] road-wheel steer angle */
    bicycle_with_accelerometer_population_real U;    /* [m/s] forward speed */
    bicycle_with_accelerometer_population_real measured; /* [rad/s] measured yaw rate */
    bicycle_with_accelerometer_population_real ay_measured; /* [m/s^2] measured lateral acceleration */
} bicycle_with_accelerometer_population_sample;

typedef struct bicycle_with_accelerometer_population_output {
    bicycle_with_accelerometer_population_real estimate; /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_with_accelerometer_population_real variance; /* [-] variance of ln K */
    bicycle_with_accelerometer_population_real predicted; /* [rad/s] yaw rate predicted before the measurement */
    bicycle_with_accelerometer_population_real innovation; /* [rad/s] measured minus predicted; 0 without a measurement */
    bicycle_with_accelerometer_population_real innovation_variance; /* [(rad/s)^2] variance of the innovation */
    bicycle_with_accelerometer_population_real information_gained; /* [-] information gained about ln K so far */
    bicycle_with_accelerometer_population_real own_variance; /* [-] variance of ln K that the filter goes by */
    bicycle_with_accelerometer_population_real pi1_now; /* [-] a/L, position of the centre of gravity */
    bicycle_with_accelerometer_population_real eta_now; /* [-] rear over front cornering coefficient; > 1 understeers */
    bicycle_with_accelerometer_population_real rho_now; /* [-] Iz/(m a b), yaw inertia ratio */
    bicycle_with_accelerometer_population_real grip_now; /* [m/s^2] mu g, greatest lateral acceleration */
    bicycle_with_accelerometer_population_real place_now; /* [-] accelerometer behind the front axle over L */
    bicycle_with_accelerometer_population_real offset_now; /* [rad] offset of delta */
    bicycle_with_accelerometer_population_real bias_now; /* [rad/s] bias of r */
    bicycle_with_accelerometer_population_real noise_now; /* [(rad/s)^2] variance of the measurement */
    bicycle_with_accelerometer_population_real disturbance_now; /* [(rad)^2] variance of the disturbance in the long run */
} bicycle_with_accelerometer_population_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void bicycle_with_accelerometer_population_init(const bicycle_with_accelerometer_population_config *config, bicycle_with_accelerometer_population_state *state)
{
    bicycle_with_accelerometer_population_real *const P = state->P;
    int i;
    for (i = 0; i < 91; ++i) {
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
    state->place = config->place_prior;
    state->input_scale = R(1.0);
    state->input_offset = R(0.0);
    state->output_bias = R(0.0);
    P[0] = (config->v_star_sd*config->v_star_sd);
    P[13] = (config->r_star_sd*config->r_star_sd);
    P[81] = (config->input_scale_sd*config->input_scale_sd);
    P[85] = (config->input_offset_sd*config->input_offset_sd);
    P[88] = (config->output_bias_sd*config->output_bias_sd);
    P[90] = (config->ay_bias_sd*config->ay_bias_sd);
    P[36] = config->P_prior[0];
    P[37] = config->P_prior[1];
    P[38] = config->P_prior[2];
    P[39] = config->P_prior[3];
    P[40] = config->P_prior[4];
    P[41] = config->P_prior[5];
    P[46] = config->P_prior[6];
    P[47] = config->P_prior[7];
    P[48] = config->P_prior[8];
    P[49] = config->P_prior[9];
    P[50] = config->P_prior[10];
    P[55] = config->P_prior[11];
    P[56] = config->P_prior[12];
    P[57] = config->P_prior[13];
    P[58] = config->P_prior[14];
    P[63] = config->P_prior[15];
    P[64] = config->P_prior[16];
    P[65] = config->P_prior[17];
    P[70] = config->P_prior[18];
    P[71] = config->P_prior[19];
    P[76] = config->P_prior[20];
    state->noise_scale = R(1.0);
    state->surprise = R(1.0);
    state->settling = R(1.0);
    state->disturbance_scale = config->disturbance_scale_start;
    state->ay_noise_scale = R(1.0);
    P[25] = state->disturbance_scale*(config->disturbance_floor*config->disturbance_floor);
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
    state->ay_bias = R(0.0);
    state->ay_activity = R(0.0);
    state->input_offset_plain = R(0.0);
}

/* A part of the step: propagate. */
SIMILITUDE_PART void bicycle_with_accelerometer_population_propagate(
        const bicycle_with_accelerometer_population_config *config,
        bicycle_with_accelerometer_population_state *state,
        const bicycle_with_accelerometer_population_sample *sample,
        const bicycle_with_accelerometer_population_real steer,
        const bicycle_with_accelerometer_population_real F_v_star_K,
        const bicycle_with_accelerometer_population_real F_v_star_eta,
        const bicycle_with_accelerometer_population_real F_v_star_grip,
        const bicycle_with_accelerometer_population_real F_v_star_pi1,
        const bicycle_with_accelerometer_population_real F_v_star_place,
        const bicycle_with_accelerometer_population_real F_v_star_r_star,
        const bicycle_with_accelerometer_population_real F_v_star_rho,
        const bicycle_with_accelerometer_population_real F_v_star_u,
        const bicycle_with_accelerometer_population_real F_v_star_v_star,
        const bicycle_with_accelerometer_population_real F_r_star_K,
        const bicycle_with_accelerometer_population_real F_r_star_eta,
        const bicycle_with_accelerometer_population_real F_r_star_grip,
        const bicycle_with_accelerometer_population_real F_r_star_pi1,
        const bicycle_with_accelerometer_population_real F_r_star_place,
        const bicycle_with_accelerometer_population_real F_r_star_r_star,
        const bicycle_with_accelerometer_population_real F_r_star_rho,
        const bicycle_with_accelerometer_population_real F_r_star_u,
        const bicycle_with_accelerometer_population_real F_r_star_v_star,
        const bicycle_with_accelerometer_population_real keep_w,
        const bicycle_with_accelerometer_population_real w_nominal,
        const bicycle_with_accelerometer_population_real diffusion)
{
    bicycle_with_accelerometer_population_real *const P = state->P;
    const bicycle_with_accelerometer_population_real PW_0 = P[10] + P[2] + P[9]*steer;
    const bicycle_with_accelerometer_population_real FP_0_0 = F_v_star_K*P[3] + F_v_star_eta*P[5] + F_v_star_grip*P[7] + F_v_star_pi1*P[4] + F_v_star_place*P[8] + F_v_star_r_star*P[1] + F_v_star_rho*P[6] + F_v_star_u*PW_0 + F_v_star_v_star*P[0];
    const bicycle_with_accelerometer_population_real FP_1_0 = F_r_star_K*P[3] + F_r_star_eta*P[5] + F_r_star_grip*P[7] + F_r_star_pi1*P[4] + F_r_star_place*P[8] + F_r_star_r_star*P[1] + F_r_star_rho*P[6] + F_r_star_u*PW_0 + F_r_star_v_star*P[0];
    const bicycle_with_accelerometer_population_real PW_1 = P[14] + P[22] + P[21]*steer;
    const bicycle_with_accelerometer_population_real FP_0_1 = F_v_star_K*P[15] + F_v_star_eta*P[17] + F_v_star_grip*P[19] + F_v_star_pi1*P[16] + F_v_star_place*P[20] + F_v_star_r_star*P[13] + F_v_star_rho*P[18] + F_v_star_u*PW_1 + F_v_star_v_star*P[1];
    const bicycle_with_accelerometer_population_real FP_1_1 = F_r_star_K*P[15] + F_r_star_eta*P[17] + F_r_star_grip*P[19] + F_r_star_pi1*P[16] + F_r_star_place*P[20] + F_r_star_r_star*P[13] + F_r_star_rho*P[18] + F_r_star_u*PW_1 + F_r_star_v_star*P[1];
    P[0] = FP_0_0*F_v_star_v_star + FP_0_1*F_v_star_r_star;
    P[1] = FP_0_0*F_r_star_v_star + FP_0_1*F_r_star_r_star;
    P[13] = FP_1_0*F_r_star_v_star + FP_1_1*F_r_star_r_star;
    const bicycle_with_accelerometer_population_real PW_2 = P[25] + P[33] + P[32]*steer;
    const bicycle_with_accelerometer_population_real FP_0_2 = F_v_star_K*P[26] + F_v_star_eta*P[28] + F_v_star_grip*P[30] + F_v_star_pi1*P[27] + F_v_star_place*P[31] + F_v_star_r_star*P[14] + F_v_star_rho*P[29] + F_v_star_u*PW_2 + F_v_star_v_star*P[2];
    const bicycle_with_accelerometer_population_real FP_1_2 = F_r_star_K*P[26] + F_r_star_eta*P[28] + F_r_star_grip*P[30] + F_r_star_pi1*P[27] + F_r_star_place*P[31] + F_r_star_r_star*P[14] + F_r_star_rho*P[29] + F_r_star_u*PW_2 + F_r_star_v_star*P[2];
    P[2] = FP_0_2*keep_w;
    P[14] = FP_1_2*keep_w;
    const bicycle_with_accelerometer_population_real PW_3 = P[26] + P[43] + P[42]*steer;
    const bicycle_with_accelerometer_population_real FP_0_3 = F_v_star_K*P[36] + F_v_star_eta*P[38] + F_v_star_grip*P[40] + F_v_star_pi1*P[37] + F_v_star_place*P[41] + F_v_star_r_star*P[15] + F_v_star_rho*P[39] + F_v_star_u*PW_3 + F_v_star_v_star*P[3];
    const bicycle_with_accelerometer_population_real FP_1_3 = F_r_star_K*P[36] + F_r_star_eta*P[38] + F_r_star_grip*P[40] + F_r_star_pi1*P[37] + F_r_star_place*P[41] + F_r_star_r_star*P[15] + F_r_star_rho*P[39] + F_r_star_u*PW_3 + F_r_star_v_star*P[3];
    P[3] = FP_0_3;
    P[15] = FP_1_3;
    P[0] = P[0] + FP_0_3*F_v_star_K;
    P[1] = P[1] + FP_0_3*F_r_star_K;
    P[13] = P[13] + FP_1_3*F_r_star_K;
    const bicycle_with_accelerometer_population_real PW_4 = P[27] + P[52] + P[51]*steer;
    const bicycle_with_accelerometer_population_real FP_0_4 = F_v_star_K*P[37] + F_v_star_eta*P[47] + F_v_star_grip*P[49] + F_v_star_pi1*P[46] + F_v_star_place*P[50] + F_v_star_r_star*P[16] + F_v_star_rho*P[48] + F_v_star_u*PW_4 + F_v_star_v_star*P[4];
    const bicycle_with_accelerometer_population_real FP_1_4 = F_r_star_K*P[37] + F_r_star_eta*P[47] + F_r_star_grip*P[49] + F_r_star_pi1*P[46] + F_r_star_place*P[50] + F_r_star_r_star*P[16] + F_r_star_rho*P[48] + F_r_star_u*PW_4 + F_r_star_v_star*P[4];
    P[4] = FP_0_4;
    P[16] = FP_1_4;
    P[0] = P[0] + FP_0_4*F_v_star_pi1;
    P[1] = P[1] + FP_0_4*F_r_star_pi1;
    P[13] = P[13] + FP_1_4*F_r_star_pi1;
    const bicycle_with_accelerometer_population_real PW_5 = P[28] + P[60] + P[59]*steer;
    const bicycle_with_accelerometer_population_real FP_0_5 = F_v_star_K*P[38] + F_v_star_eta*P[55] + F_v_star_grip*P[57] + F_v_star_pi1*P[47] + F_v_star_place*P[58] + F_v_star_r_star*P[17] + F_v_star_rho*P[56] + F_v_star_u*PW_5 + F_v_star_v_star*P[5];
    const bicycle_with_accelerometer_population_real FP_1_5 = F_r_star_K*P[38] + F_r_star_eta*P[55] + F_r_star_grip*P[57] + F_r_star_pi1*P[47] + F_r_star_place*P[58] + F_r_star_r_star*P[17] + F_r_star_rho*P[56] + F_r_star_u*PW_5 + F_r_star_v_star*P[5];
    P[5] = FP_0_5;
    P[17] = FP_1_5;
    P[0] = P[0] + FP_0_5*F_v_star_eta;
    P[1] = P[1] + FP_0_5*F_r_star_eta;
    P[13] = P[13] + FP_1_5*F_r_star_eta;
    const bicycle_with_accelerometer_population_real PW_6 = P[29] + P[67] + P[66]*steer;
    const bicycle_with_accelerometer_population_real FP_0_6 = F_v_star_K*P[39] + F_v_star_eta*P[56] + F_v_star_grip*P[64] + F_v_star_pi1*P[48] + F_v_star_place*P[65] + F_v_star_r_star*P[18] + F_v_star_rho*P[63] + F_v_star_u*PW_6 + F_v_star_v_star*P[6];
    const bicycle_with_accelerometer_population_real FP_1_6 = F_r_star_K*P[39] + F_r_star_eta*P[56] + F_r_star_grip*P[64] + F_r_star_pi1*P[48] + F_r_star_place*P[65] + F_r_star_r_star*P[18] + F_r_star_rho*P[63] + F_r_star_u*PW_6 + F_r_star_v_star*P[6];
    P[6] = FP_0_6;
    P[18] = FP_1_6;
    P[0] = P[0] + FP_0_6*F_v_star_rho;
    P[1] = P[1] + FP_0_6*F_r_star_rho;
    P[13] = P[13] + FP_1_6*F_r_star_rho;
    const bicycle_with_accelerometer_population_real PW_7 = P[30] + P[73] + P[72]*steer;
    const bicycle_with_accelerometer_population_real FP_0_7 = F_v_star_K*P[40] + F_v_star_eta*P[57] + F_v_star_grip*P[70] + F_v_star_pi1*P[49] + F_v_star_place*P[71] + F_v_star_r_star*P[19] + F_v_star_rho*P[64] + F_v_star_u*PW_7 + F_v_star_v_star*P[7];
    const bicycle_with_accelerometer_population_real FP_1_7 = F_r_star_K*P[40] + F_r_star_eta*P[57] + F_r_star_grip*P[70] + F_r_star_pi1*P[49] + F_r_star_place*P[71] + F_r_star_r_star*P[19] + F_r_star_rho*P[64] + F_r_star_u*PW_7 + F_r_star_v_star*P[7];
    P[7] = FP_0_7;
    P[19] = FP_1_7;
    P[0] = P[0] + FP_0_7*F_v_star_grip;
    P[1] = P[1] + FP_0_7*F_r_star_grip;
    P[13] = P[13] + FP_1_7*F_r_star_grip;
    const bicycle_with_accelerometer_population_real PW_8 = P[31] + P[78] + P[77]*steer;
    const bicycle_with_accelerometer_population_real FP_0_8 = F_v_star_K*P[41] + F_v_star_eta*P[58] + F_v_star_grip*P[71] + F_v_star_pi1*P[50] + F_v_star_place*P[76] + F_v_star_r_star*P[20] + F_v_star_rho*P[65] + F_v_star_u*PW_8 + F_v_star_v_star*P[8];
    const bicycle_with_accelerometer_population_real FP_1_8 = F_r_star_K*P[41] + F_r_star_eta*P[58] + F_r_star_grip*P[71] + F_r_star_pi1*P[50] + F_r_star_place*P[76] + F_r_star_r_star*P[20] + F_r_star_rho*P[65] + F_r_star_u*PW_8 + F_r_star_v_star*P[8];
    P[8] = FP_0_8;
    P[20] = FP_1_8;
    P[0] = P[0] + FP_0_8*F_v_star_place;
    P[1] = P[1] + FP_0_8*F_r_star_place;
    P[13] = P[13] + FP_1_8*F_r_star_place;
    const bicycle_with_accelerometer_population_real PW_9 = P[32] + P[82] + P[81]*steer;
    const bicycle_with_accelerometer_population_real FP_0_9 = F_v_star_K*P[42] + F_v_star_eta*P[59] + F_v_star_grip*P[72] + F_v_star_pi1*P[51] + F_v_star_place*P[77] + F_v_star_r_star*P[21] + F_v_star_rho*P[66] + F_v_star_u*PW_9 + F_v_star_v_star*P[9];
    const bicycle_with_accelerometer_population_real FP_1_9 = F_r_star_K*P[42] + F_r_star_eta*P[59] + F_r_star_grip*P[72] + F_r_star_pi1*P[51] + F_r_star_place*P[77] + F_r_star_r_star*P[21] + F_r_star_rho*P[66] + F_r_star_u*PW_9 + F_r_star_v_star*P[9];
    P[9] = FP_0_9;
    P[21] = FP_1_9;
    const bicycle_with_accelerometer_population_real PW_10 = P[33] + P[85] + P[82]*steer;
    const bicycle_with_accelerometer_population_real FP_0_10 = F_v_star_K*P[43] + F_v_star_eta*P[60] + F_v_star_grip*P[73] + F_v_star_pi1*P[52] + F_v_star_place*P[78] + F_v_star_r_star*P[22] + F_v_star_rho*P[67] + F_v_star_u*PW_10 + F_v_star_v_star*P[10];
    const bicycle_with_accelerometer_population_real FP_1_10 = F_r_star_K*P[43] + F_r_star_eta*P[60] + F_r_star_grip*P[73] + F_r_star_pi1*P[52] + F_r_star_place*P[78] + F_r_star_r_star*P[22] + F_r_star_rho*P[67] + F_r_star_u*PW_10 + F_r_star_v_star*P[10];
    P[10] = FP_0_10;
    P[22] = FP_1_10;
    const bicycle_with_accelerometer_population_real PW_11 = P[34] + P[86] + P[83]*steer;
    const bicycle_with_accelerometer_population_real FP_0_11 = F_v_star_K*P[44] + F_v_star_eta*P[61] + F_v_star_grip*P[74] + F_v_star_pi1*P[53] + F_v_star_place*P[79] + F_v_star_r_star*P[23] + F_v_star_rho*P[68] + F_v_star_u*PW_11 + F_v_star_v_star*P[11];
    const bicycle_with_accelerometer_population_real FP_1_11 = F_r_star_K*P[44] + F_r_star_eta*P[61] + F_r_star_grip*P[74] + F_r_star_pi1*P[53] + F_r_star_place*P[79] + F_r_star_r_star*P[23] + F_r_star_rho*P[68] + F_r_star_u*PW_11 + F_r_star_v_star*P[11];
    P[11] = FP_0_11;
    P[23] = FP_1_11;
    const bicycle_with_accelerometer_population_real PW_12 = P[35] + P[87] + P[84]*steer;
    const bicycle_with_accelerometer_population_real FP_0_12 = F_v_star_K*P[45] + F_v_star_eta*P[62] + F_v_star_grip*P[75] + F_v_star_pi1*P[54] + F_v_star_place*P[80] + F_v_star_r_star*P[24] + F_v_star_rho*P[69] + F_v_star_u*PW_12 + F_v_star_v_star*P[12];
    const bicycle_with_accelerometer_population_real FP_1_12 = F_r_star_K*P[45] + F_r_star_eta*P[62] + F_r_star_grip*P[75] + F_r_star_pi1*P[54] + F_r_star_place*P[80] + F_r_star_r_star*P[24] + F_r_star_rho*P[69] + F_r_star_u*PW_12 + F_r_star_v_star*P[12];
    P[12] = FP_0_12;
    P[24] = FP_1_12;
    const bicycle_with_accelerometer_population_real WPF_0 = FP_0_10 + FP_0_2 + FP_0_9*steer;
    const bicycle_with_accelerometer_population_real WPF_1 = FP_1_10 + FP_1_2 + FP_1_9*steer;
    P[0] = P[0] + F_v_star_u*WPF_0;
    P[1] = P[1] + F_r_star_u*WPF_0;
    P[13] = P[13] + F_r_star_u*WPF_1;
    P[25] = P[25]*(keep_w*keep_w) + state->disturbance_scale*w_nominal*(R(1.0) - (keep_w*keep_w));
    P[26] = P[26]*keep_w;
    P[27] = P[27]*keep_w;
    P[28] = P[28]*keep_w;
    P[29] = P[29]*keep_w;
    P[30] = P[30]*keep_w;
    P[31] = P[31]*keep_w;
    P[32] = P[32]*keep_w;
    P[33] = P[33]*keep_w;
    P[34] = P[34]*keep_w;
    P[35] = P[35]*keep_w;
    P[36] = P[36] + sample->dt*(diffusion + state->jump*config->jump_drift);
    P[88] = P[88] + config->bias_drift*sample->dt;
    P[90] = P[90] + config->ay_bias_drift*sample->dt;
}

/* A part of the step: correct. */
SIMILITUDE_PART void bicycle_with_accelerometer_population_correct(
        bicycle_with_accelerometer_population_state *state,
        const bicycle_with_accelerometer_population_real output_scale,
        const bicycle_with_accelerometer_population_real inv_spread,
        const bicycle_with_accelerometer_population_real c_1,
        const bicycle_with_accelerometer_population_real learn_seldom,
        const bicycle_with_accelerometer_population_real learn_slow,
        const bicycle_with_accelerometer_population_real learn_beyond,
        const bicycle_with_accelerometer_population_real c_11,
        const bicycle_with_accelerometer_population_real c_3,
        const bicycle_with_accelerometer_population_real gain_3,
        const bicycle_with_accelerometer_population_real innovation)
{
    bicycle_with_accelerometer_population_real *const P = state->P;
    const bicycle_with_accelerometer_population_real c_0 = P[11] + P[1]*output_scale;
    const bicycle_with_accelerometer_population_real c_2 = P[34] + P[14]*output_scale;
    const bicycle_with_accelerometer_population_real c_4 = P[53] + P[16]*output_scale;
    const bicycle_with_accelerometer_population_real c_5 = P[61] + P[17]*output_scale;
    const bicycle_with_accelerometer_population_real c_6 = P[68] + P[18]*output_scale;
    const bicycle_with_accelerometer_population_real c_7 = P[74] + P[19]*output_scale;
    const bicycle_with_accelerometer_population_real c_8 = P[79] + P[20]*output_scale;
    const bicycle_with_accelerometer_population_real c_9 = P[83] + P[21]*output_scale;
    const bicycle_with_accelerometer_population_real c_10 = P[86] + P[22]*output_scale;
    const bicycle_with_accelerometer_population_real c_12 = P[89] + P[24]*output_scale;
    const bicycle_with_accelerometer_population_real gain_0 = c_0*inv_spread;
    const bicycle_with_accelerometer_population_real gain_1 = c_1*inv_spread;
    const bicycle_with_accelerometer_population_real gain_2 = c_2*inv_spread;
    const bicycle_with_accelerometer_population_real gain_4 = c_4*learn_seldom;
    const bicycle_with_accelerometer_population_real gain_5 = c_5*learn_slow;
    const bicycle_with_accelerometer_population_real gain_6 = c_6*learn_slow;
    const bicycle_with_accelerometer_population_real gain_7 = c_7*learn_beyond;
    const bicycle_with_accelerometer_population_real gain_8 = c_8*learn_slow;
    const bicycle_with_accelerometer_population_real gain_9 = c_9*learn_slow;
    const bicycle_with_accelerometer_population_real gain_10 = c_10*inv_spread;
    const bicycle_with_accelerometer_population_real gain_11 = c_11*inv_spread;
    const bicycle_with_accelerometer_population_real gain_12 = c_12*inv_spread;
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
    P[11] = P[11] - c_11*gain_0;
    P[12] = P[12] - c_12*gain_0;
    P[13] = P[13] - c_1*gain_1;
    P[14] = P[14] - c_2*gain_1;
    P[15] = P[15] - c_3*gain_1;
    P[16] = P[16] - c_4*gain_1;
    P[17] = P[17] - c_5*gain_1;
    P[18] = P[18] - c_6*gain_1;
    P[19] = P[19] - c_7*gain_1;
    P[20] = P[20] - c_8*gain_1;
    P[21] = P[21] - c_9*gain_1;
    P[22] = P[22] - c_10*gain_1;
    P[23] = P[23] - c_11*gain_1;
    P[24] = P[24] - c_12*gain_1;
    P[25] = P[25] - c_2*gain_2;
    P[26] = P[26] - c_3*gain_2;
    P[27] = P[27] - c_4*gain_2;
    P[28] = P[28] - c_5*gain_2;
    P[29] = P[29] - c_6*gain_2;
    P[30] = P[30] - c_7*gain_2;
    P[31] = P[31] - c_8*gain_2;
    P[32] = P[32] - c_9*gain_2;
    P[33] = P[33] - c_10*gain_2;
    P[34] = P[34] - c_11*gain_2;
    P[35] = P[35] - c_12*gain_2;
    P[36] = P[36] - c_3*gain_3;
    P[37] = P[37] - c_4*gain_3;
    P[38] = P[38] - c_5*gain_3;
    P[39] = P[39] - c_6*gain_3;
    P[40] = P[40] - c_3*gain_7;
    P[41] = P[41] - c_8*gain_3;
    P[42] = P[42] - c_9*gain_3;
    P[43] = P[43] - c_3*gain_10;
    P[44] = P[44] - c_3*gain_11;
    P[45] = P[45] - c_3*gain_12;
    P[46] = P[46] - c_4*gain_4;
    P[47] = P[47] - c_4*gain_5;
    P[48] = P[48] - c_4*gain_6;
    P[49] = P[49] - c_4*gain_7;
    P[50] = P[50] - c_4*gain_8;
    P[51] = P[51] - c_4*gain_9;
    P[52] = P[52] - c_4*gain_10;
    P[53] = P[53] - c_4*gain_11;
    P[54] = P[54] - c_4*gain_12;
    P[55] = P[55] - c_5*gain_5;
    P[56] = P[56] - c_6*gain_5;
    P[57] = P[57] - c_5*gain_7;
    P[58] = P[58] - c_8*gain_5;
    P[59] = P[59] - c_9*gain_5;
    P[60] = P[60] - c_5*gain_10;
    P[61] = P[61] - c_5*gain_11;
    P[62] = P[62] - c_5*gain_12;
    P[63] = P[63] - c_6*gain_6;
    P[64] = P[64] - c_6*gain_7;
    P[65] = P[65] - c_8*gain_6;
    P[66] = P[66] - c_9*gain_6;
    P[67] = P[67] - c_6*gain_10;
    P[68] = P[68] - c_6*gain_11;
    P[69] = P[69] - c_6*gain_12;
    P[70] = P[70] - c_7*gain_7;
    P[71] = P[71] - c_8*gain_7;
    P[72] = P[72] - c_9*gain_7;
    P[73] = P[73] - c_7*gain_10;
    P[74] = P[74] - c_7*gain_11;
    P[75] = P[75] - c_7*gain_12;
    P[76] = P[76] - c_8*gain_8;
    P[77] = P[77] - c_9*gain_8;
    P[78] = P[78] - c_8*gain_10;
    P[79] = P[79] - c_8*gain_11;
    P[80] = P[80] - c_8*gain_12;
    P[81] = P[81] - c_9*gain_9;
    P[82] = P[82] - c_9*gain_10;
    P[83] = P[83] - c_9*gain_11;
    P[84] = P[84] - c_9*gain_12;
    P[85] = P[85] - c_10*gain_10;
    P[86] = P[86] - c_11*gain_10;
    P[87] = P[87] - c_12*gain_10;
    P[88] = P[88] - c_11*gain_11;
    P[89] = P[89] - c_12*gain_11;
    P[90] = P[90] - c_12*gain_12;
    state->v_star = state->v_star + gain_0*innovation;
    state->r_star = state->r_star + gain_1*innovation;
    state->disturbance = state->disturbance + gain_2*innovation;
    state->pi1 = state->pi1 + gain_4*innovation;
    const bicycle_with_accelerometer_population_real move_eta = gain_5*innovation;
    const bicycle_with_accelerometer_population_real above_move_eta = (((-R(1.0))) > (move_eta) ? (-R(1.0)) : move_eta);
    const bicycle_with_accelerometer_population_real bounded_move_eta = ((R(1.0)) < (above_move_eta) ? R(1.0) : above_move_eta);
    state->eta = state->eta*(R(1.0) + bounded_move_eta*(R(1.0) + bounded_move_eta*(R(0.5) + R(0.16666666666666666)*bounded_move_eta)));
    const bicycle_with_accelerometer_population_real move_rho = gain_6*innovation;
    const bicycle_with_accelerometer_population_real above_move_rho = (((-R(1.0))) > (move_rho) ? (-R(1.0)) : move_rho);
    const bicycle_with_accelerometer_population_real bounded_move_rho = ((R(1.0)) < (above_move_rho) ? R(1.0) : above_move_rho);
    state->rho = state->rho*(R(1.0) + bounded_move_rho*(R(1.0) + bounded_move_rho*(R(0.5) + R(0.16666666666666666)*bounded_move_rho)));
    const bicycle_with_accelerometer_population_real move_grip = gain_7*innovation;
    const bicycle_with_accelerometer_population_real above_move_grip = (((-R(1.0))) > (move_grip) ? (-R(1.0)) : move_grip);
    const bicycle_with_accelerometer_population_real bounded_move_grip = ((R(1.0)) < (above_move_grip) ? R(1.0) : above_move_grip);
    state->grip = state->grip*(R(1.0) + bounded_move_grip*(R(1.0) + bounded_move_grip*(R(0.5) + R(0.16666666666666666)*bounded_move_grip)));
    state->place = state->place + gain_8*innovation;
    const bicycle_with_accelerometer_population_real move_input_scale = gain_9*innovation;
    const bicycle_with_accelerometer_population_real above_move_input_scale = (((-R(1.0))) > (move_input_scale) ? (-R(1.0)) : move_input_scale);
    const bicycle_with_accelerometer_population_real bounded_move_input_scale = ((R(1.0)) < (above_move_input_scale) ? R(1.0) : above_move_input_scale);
    state->input_scale = state->input_scale*(R(1.0) + bounded_move_input_scale*(R(1.0) + bounded_move_input_scale*(R(0.5) + R(0.16666666666666666)*bounded_move_input_scale)));
    state->input_offset = state->input_offset + gain_10*innovation;
    state->output_bias = state->output_bias + gain_11*innovation;
    state->ay_bias = state->ay_bias + gain_12*innovation;
}

/* A part of the step: correct_by_ay. */
SIMILITUDE_PART void bicycle_with_accelerometer_population_correct_by_ay(
        bicycle_with_accelerometer_population_state *state,
        const bicycle_with_accelerometer_population_real ay_by_K,
        const bicycle_with_accelerometer_population_real ay_by_eta,
        const bicycle_with_accelerometer_population_real ay_by_grip,
        const bicycle_with_accelerometer_population_real ay_by_pi1,
        const bicycle_with_accelerometer_population_real ay_by_place,
        const bicycle_with_accelerometer_population_real ay_by_r_star,
        const bicycle_with_accelerometer_population_real ay_by_rho,
        const bicycle_with_accelerometer_population_real ay_by_u,
        const bicycle_with_accelerometer_population_real ay_by_v_star,
        const bicycle_with_accelerometer_population_real u_now,
        const bicycle_with_accelerometer_population_real ay_c_0,
        const bicycle_with_accelerometer_population_real ay_inv_spread,
        const bicycle_with_accelerometer_population_real ay_c_1,
        const bicycle_with_accelerometer_population_real ay_c_2,
        const bicycle_with_accelerometer_population_real ay_c_4,
        const bicycle_with_accelerometer_population_real ay_learn_seldom,
        const bicycle_with_accelerometer_population_real ay_c_5,
        const bicycle_with_accelerometer_population_real ay_learn_slow,
        const bicycle_with_accelerometer_population_real ay_c_6,
        const bicycle_with_accelerometer_population_real ay_c_7,
        const bicycle_with_accelerometer_population_real ay_learn_beyond,
        const bicycle_with_accelerometer_population_real ay_c_8,
        const bicycle_with_accelerometer_population_real ay_c_9,
        const bicycle_with_accelerometer_population_real ay_c_10,
        const bicycle_with_accelerometer_population_real ay_c_12,
        const bicycle_with_accelerometer_population_real ay_c_3,
        const bicycle_with_accelerometer_population_real ay_gain_3,
        const bicycle_with_accelerometer_population_real ay_innovation)
{
    bicycle_with_accelerometer_population_real *const P = state->P;
    const bicycle_with_accelerometer_population_real ay_c_11 = (P[89] + P[11]*ay_by_v_star + P[23]*ay_by_r_star + P[34]*ay_by_u + P[44]*ay_by_K + P[53]*ay_by_pi1) + (P[61]*ay_by_eta + P[68]*ay_by_rho + P[74]*ay_by_grip + P[79]*ay_by_place + P[86]*ay_by_u + P[83]*ay_by_u*state->input_scale*u_now);
    const bicycle_with_accelerometer_population_real ay_gain_0 = ay_c_0*ay_inv_spread;
    const bicycle_with_accelerometer_population_real ay_gain_1 = ay_c_1*ay_inv_spread;
    const bicycle_with_accelerometer_population_real ay_gain_2 = ay_c_2*ay_inv_spread;
    const bicycle_with_accelerometer_population_real ay_gain_4 = ay_c_4*ay_learn_seldom;
    const bicycle_with_accelerometer_population_real ay_gain_5 = ay_c_5*ay_learn_slow;
    const bicycle_with_accelerometer_population_real ay_gain_6 = ay_c_6*ay_learn_slow;
    const bicycle_with_accelerometer_population_real ay_gain_7 = ay_c_7*ay_learn_beyond;
    const bicycle_with_accelerometer_population_real ay_gain_8 = ay_c_8*ay_learn_slow;
    const bicycle_with_accelerometer_population_real ay_gain_9 = ay_c_9*ay_learn_slow;
    const bicycle_with_accelerometer_population_real ay_gain_10 = ay_c_10*ay_inv_spread;
    const bicycle_with_accelerometer_population_real ay_gain_11 = ay_c_11*ay_inv_spread;
    const bicycle_with_accelerometer_population_real ay_gain_12 = ay_c_12*ay_inv_spread;
    P[0] = P[0] - ay_c_0*ay_gain_0;
    P[1] = P[1] - ay_c_1*ay_gain_0;
    P[2] = P[2] - ay_c_2*ay_gain_0;
    P[3] = P[3] - ay_c_3*ay_gain_0;
    P[4] = P[4] - ay_c_4*ay_gain_0;
    P[5] = P[5] - ay_c_5*ay_gain_0;
    P[6] = P[6] - ay_c_6*ay_gain_0;
    P[7] = P[7] - ay_c_7*ay_gain_0;
    P[8] = P[8] - ay_c_8*ay_gain_0;
    P[9] = P[9] - ay_c_9*ay_gain_0;
    P[10] = P[10] - ay_c_10*ay_gain_0;
    P[11] = P[11] - ay_c_11*ay_gain_0;
    P[12] = P[12] - ay_c_12*ay_gain_0;
    P[13] = P[13] - ay_c_1*ay_gain_1;
    P[14] = P[14] - ay_c_2*ay_gain_1;
    P[15] = P[15] - ay_c_3*ay_gain_1;
    P[16] = P[16] - ay_c_4*ay_gain_1;
    P[17] = P[17] - ay_c_5*ay_gain_1;
    P[18] = P[18] - ay_c_6*ay_gain_1;
    P[19] = P[19] - ay_c_7*ay_gain_1;
    P[20] = P[20] - ay_c_8*ay_gain_1;
    P[21] = P[21] - ay_c_9*ay_gain_1;
    P[22] = P[22] - ay_c_10*ay_gain_1;
    P[23] = P[23] - ay_c_11*ay_gain_1;
    P[24] = P[24] - ay_c_12*ay_gain_1;
    P[25] = P[25] - ay_c_2*ay_gain_2;
    P[26] = P[26] - ay_c_3*ay_gain_2;
    P[27] = P[27] - ay_c_4*ay_gain_2;
    P[28] = P[28] - ay_c_5*ay_gain_2;
    P[29] = P[29] - ay_c_6*ay_gain_2;
    P[30] = P[30] - ay_c_7*ay_gain_2;
    P[31] = P[31] - ay_c_8*ay_gain_2;
    P[32] = P[32] - ay_c_9*ay_gain_2;
    P[33] = P[33] - ay_c_10*ay_gain_2;
    P[34] = P[34] - ay_c_11*ay_gain_2;
    P[35] = P[35] - ay_c_12*ay_gain_2;
    P[36] = P[36] - ay_c_3*ay_gain_3;
    P[37] = P[37] - ay_c_4*ay_gain_3;
    P[38] = P[38] - ay_c_5*ay_gain_3;
    P[39] = P[39] - ay_c_6*ay_gain_3;
    P[40] = P[40] - ay_c_3*ay_gain_7;
    P[41] = P[41] - ay_c_8*ay_gain_3;
    P[42] = P[42] - ay_c_9*ay_gain_3;
    P[43] = P[43] - ay_c_3*ay_gain_10;
    P[44] = P[44] - ay_c_3*ay_gain_11;
    P[45] = P[45] - ay_c_3*ay_gain_12;
    P[46] = P[46] - ay_c_4*ay_gain_4;
    P[47] = P[47] - ay_c_4*ay_gain_5;
    P[48] = P[48] - ay_c_4*ay_gain_6;
    P[49] = P[49] - ay_c_4*ay_gain_7;
    P[50] = P[50] - ay_c_4*ay_gain_8;
    P[51] = P[51] - ay_c_4*ay_gain_9;
    P[52] = P[52] - ay_c_4*ay_gain_10;
    P[53] = P[53] - ay_c_4*ay_gain_11;
    P[54] = P[54] - ay_c_4*ay_gain_12;
    P[55] = P[55] - ay_c_5*ay_gain_5;
    P[56] = P[56] - ay_c_6*ay_gain_5;
    P[57] = P[57] - ay_c_5*ay_gain_7;
    P[58] = P[58] - ay_c_8*ay_gain_5;
    P[59] = P[59] - ay_c_9*ay_gain_5;
    P[60] = P[60] - ay_c_5*ay_gain_10;
    P[61] = P[61] - ay_c_5*ay_gain_11;
    P[62] = P[62] - ay_c_5*ay_gain_12;
    P[63] = P[63] - ay_c_6*ay_gain_6;
    P[64] = P[64] - ay_c_6*ay_gain_7;
    P[65] = P[65] - ay_c_8*ay_gain_6;
    P[66] = P[66] - ay_c_9*ay_gain_6;
    P[67] = P[67] - ay_c_6*ay_gain_10;
    P[68] = P[68] - ay_c_6*ay_gain_11;
    P[69] = P[69] - ay_c_6*ay_gain_12;
    P[70] = P[70] - ay_c_7*ay_gain_7;
    P[71] = P[71] - ay_c_8*ay_gain_7;
    P[72] = P[72] - ay_c_9*ay_gain_7;
    P[73] = P[73] - ay_c_7*ay_gain_10;
    P[74] = P[74] - ay_c_7*ay_gain_11;
    P[75] = P[75] - ay_c_7*ay_gain_12;
    P[76] = P[76] - ay_c_8*ay_gain_8;
    P[77] = P[77] - ay_c_9*ay_gain_8;
    P[78] = P[78] - ay_c_8*ay_gain_10;
    P[79] = P[79] - ay_c_8*ay_gain_11;
    P[80] = P[80] - ay_c_8*ay_gain_12;
    P[81] = P[81] - ay_c_9*ay_gain_9;
    P[82] = P[82] - ay_c_9*ay_gain_10;
    P[83] = P[83] - ay_c_9*ay_gain_11;
    P[84] = P[84] - ay_c_9*ay_gain_12;
    P[85] = P[85] - ay_c_10*ay_gain_10;
    P[86] = P[86] - ay_c_11*ay_gain_10;
    P[87] = P[87] - ay_c_12*ay_gain_10;
    P[88] = P[88] - ay_c_11*ay_gain_11;
    P[89] = P[89] - ay_c_12*ay_gain_11;
    P[90] = P[90] - ay_c_12*ay_gain_12;
    state->v_star = state->v_star + ay_gain_0*ay_innovation;
    state->r_star = state->r_star + ay_gain_1*ay_innovation;
    state->disturbance = state->disturbance + ay_gain_2*ay_innovation;
    state->pi1 = state->pi1 + ay_gain_4*ay_innovation;
    const bicycle_with_accelerometer_population_real ay_move_eta = ay_gain_5*ay_innovation;
    const bicycle_with_accelerometer_population_real above_ay_move_eta = (((-R(1.0))) > (ay_move_eta) ? (-R(1.0)) : ay_move_eta);
    const bicycle_with_accelerometer_population_real bounded_ay_move_eta = ((R(1.0)) < (above_ay_move_eta) ? R(1.0) : above_ay_move_eta);
    state->eta = state->eta*(R(1.0) + bounded_ay_move_eta*(R(1.0) + bounded_ay_move_eta*(R(0.5) + R(0.16666666666666666)*bounded_ay_move_eta)));
    const bicycle_with_accelerometer_population_real ay_move_rho = ay_gain_6*ay_innovation;
    const bicycle_with_accelerometer_population_real above_ay_move_rho = (((-R(1.0))) > (ay_move_rho) ? (-R(1.0)) : ay_move_rho);
    const bicycle_with_accelerometer_population_real bounded_ay_move_rho = ((R(1.0)) < (above_ay_move_rho) ? R(1.0) : above_ay_move_rho);
    state->rho = state->rho*(R(1.0) + bounded_ay_move_rho*(R(1.0) + bounded_ay_move_rho*(R(0.5) + R(0.16666666666666666)*bounded_ay_move_rho)));
    const bicycle_with_accelerometer_population_real ay_move_grip = ay_gain_7*ay_innovation;
    const bicycle_with_accelerometer_population_real above_ay_move_grip = (((-R(1.0))) > (ay_move_grip) ? (-R(1.0)) : ay_move_grip);
    const bicycle_with_accelerometer_population_real bounded_ay_move_grip = ((R(1.0)) < (above_ay_move_grip) ? R(1.0) : above_ay_move_grip);
    state->grip = state->grip*(R(1.0) + bounded_ay_move_grip*(R(1.0) + bounded_ay_move_grip*(R(0.5) + R(0.16666666666666666)*bounded_ay_move_grip)));
    state->place = state->place + ay_gain_8*ay_innovation;
    const bicycle_with_accelerometer_population_real ay_move_input_scale = ay_gain_9*ay_innovation;
    const bicycle_with_accelerometer_population_real above_ay_move_input_scale = (((-R(1.0))) > (ay_move_input_scale) ? (-R(1.0)) : ay_move_input_scale);
    const bicycle_with_accelerometer_population_real bounded_ay_move_input_scale = ((R(1.0)) < (above_ay_move_input_scale) ? R(1.0) : above_ay_move_input_scale);
    state->input_scale = state->input_scale*(R(1.0) + bounded_ay_move_input_scale*(R(1.0) + bounded_ay_move_input_scale*(R(0.5) + R(0.16666666666666666)*bounded_ay_move_input_scale)));
    state->input_offset = state->input_offset + ay_gain_10*ay_innovation;
    state->output_bias = state->output_bias + ay_gain_11*ay_innovation;
    state->ay_bias = state->ay_bias + ay_gain_12*ay_innovation;
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_with_accelerometer_population_advance(const bicycle_with_accelerometer_population_config *config, bicycle_with_accelerometer_population_state *state,
                                     const bicycle_with_accelerometer_population_sample *sample, bicycle_with_accelerometer_population_output *output)
{
    bicycle_with_accelerometer_population_real *const P = state->P;
    bicycle_with_accelerometer_population_real U_now = R(0.0);
    int anew = 0;
    bicycle_with_accelerometer_population_real ay_inv_spread = R(0.0);
    bicycle_with_accelerometer_population_real bias_now = R(0.0);
    bicycle_with_accelerometer_population_real diffusion = R(0.0);
    bicycle_with_accelerometer_population_real disturbance_now = R(0.0);
    bicycle_with_accelerometer_population_real estimate = R(0.0);
    bicycle_with_accelerometer_population_real eta_now = R(0.0);
    bicycle_with_accelerometer_population_real grip_now = R(0.0);
    bicycle_with_accelerometer_population_real information_gained = R(0.0);
    bicycle_with_accelerometer_population_real innovation = R(0.0);
    bicycle_with_accelerometer_population_real innovation_variance = R(0.0);
    bicycle_with_accelerometer_population_real inv_spread = R(0.0);
    bicycle_with_accelerometer_population_real move = R(0.0);
    bicycle_with_accelerometer_population_real noise_now = R(0.0);
    bicycle_with_accelerometer_population_real offset_now = R(0.0);
    bicycle_with_accelerometer_population_real own_variance = R(0.0);
    bicycle_with_accelerometer_population_real pi1_now = R(0.0);
    bicycle_with_accelerometer_population_real place_now = R(0.0);
    bicycle_with_accelerometer_population_real predicted = R(0.0);
    bicycle_with_accelerometer_population_real rho_now = R(0.0);
    int status = 0;
    bicycle_with_accelerometer_population_real u_now = R(0.0);
    int usable = 0;
    bicycle_with_accelerometer_population_real variance = R(0.0);

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
            P[30] = R(0.0);
            P[31] = R(0.0);
            P[32] = R(0.0);
            P[33] = R(0.0);
            P[34] = R(0.0);
            P[35] = R(0.0);
            P[0] = (config->v_star_sd*config->v_star_sd);
            P[13] = (config->r_star_sd*config->r_star_sd);
            P[25] = state->disturbance_scale*(config->disturbance_floor*config->disturbance_floor);
            state->v_star = R(0.0);
            state->r_star = R(0.0);
            state->v_star_plain = R(0.0);
            state->r_star_plain = R(0.0);
            state->disturbance = R(0.0);
        }
        const bicycle_with_accelerometer_population_real least_scale = R(0.0003333333333333333)*config->signal_limit;
        const bicycle_with_accelerometer_population_real at_U = ((U_now) > (least_scale) ? U_now : least_scale); /* kept off zero */
        const bicycle_with_accelerometer_population_real was_U = ((state->last_U) > (least_scale) ? state->last_U : least_scale);
        const bicycle_with_accelerometer_population_real inv_U = (R(1.0)/at_U);
        const bicycle_with_accelerometer_population_real inv_L = (R(1.0)/config->L);
        const bicycle_with_accelerometer_population_real inv_dt = (R(1.0)/sample->dt);
        const bicycle_with_accelerometer_population_real output_scale = at_U*inv_L; /* r = scale x dimensionless */
        const bicycle_with_accelerometer_population_real inv_output_scale = config->L*inv_U;
        const bicycle_with_accelerometer_population_real span = (sample->dt < config->gap ? sample->dt : R(0.0)); /* [s] the dynamics start anew at the end of a gap */
        const bicycle_with_accelerometer_population_real h = at_U*inv_L*span; /* dimensionless time step */
        const bicycle_with_accelerometer_population_real ratio_v_star = inv_U*was_U; /* same physical state in the new scales */
        state->v_star = ratio_v_star*state->v_star;
        state->v_star_plain = ratio_v_star*state->v_star_plain;
        const bicycle_with_accelerometer_population_real ratio_r_star = inv_U*was_U; /* same physical state in the new scales */
        state->r_star = state->r_star*ratio_r_star;
        state->r_star_plain = state->r_star_plain*ratio_r_star;
        const bicycle_with_accelerometer_population_real steer = R(0.5)*state->input_scale*(state->last_input + u_now); /* mean of the sample's two ends */
        const bicycle_with_accelerometer_population_real steer_change = state->input_scale*(u_now - state->last_input);
        const bicycle_with_accelerometer_population_real u_plain = state->input_offset_plain + steer; /* measured input less its offset [-] */
        const bicycle_with_accelerometer_population_real u = state->disturbance + state->input_offset + steer; /* effective input [-] */
        const bicycle_with_accelerometer_population_real inv0 = (R(1.0)/state->grip);
        const bicycle_with_accelerometer_population_real inv1 = (R(1.0)/state->rho);
        const bicycle_with_accelerometer_population_real inv2 = (R(1.0)/(state->pi1 - R(1.0)));
        const bicycle_with_accelerometer_population_real s0 = state->v_star + state->pi1*state->r_star;
        const bicycle_with_accelerometer_population_real s1 = state->K*inv0*inv2*inv_L;
        const bicycle_with_accelerometer_population_real s2 = state->v_star_plain + state->pi1*state->r_star_plain;
        const bicycle_with_accelerometer_population_real s3 = state->eta*s1;
        const bicycle_with_accelerometer_population_real load0 = s1*(s0 - u); /* force over its limit [-] */
        const bicycle_with_accelerometer_population_real load1 = s1*(s2 - u_plain); /* force over its limit [-] */
        const bicycle_with_accelerometer_population_real load2 = s3*(s0 - state->r_star); /* force over its limit [-] */
        const bicycle_with_accelerometer_population_real load3 = s3*(s2 - state->r_star_plain); /* force over its limit [-] */
        const bicycle_with_accelerometer_population_real size0 = (((-load0)) > (load0) ? (-load0) : load0);
        const bicycle_with_accelerometer_population_real over0 = R(1.0) + size0*(R(1.0) + R(0.7)*size0);
        const bicycle_with_accelerometer_population_real part0 = (R(1.0)/(R(1.0) + over0*size0)); /* force over load */
        const bicycle_with_accelerometer_population_real size1 = (((-load1)) > (load1) ? (-load1) : load1);
        const bicycle_with_accelerometer_population_real over1 = R(1.0) + size1*(R(1.0) + R(0.7)*size1);
        const bicycle_with_accelerometer_population_real part1 = (R(1.0)/(R(1.0) + over1*size1));
        const bicycle_with_accelerometer_population_real size2 = (((-load2)) > (load2) ? (-load2) : load2);
        const bicycle_with_accelerometer_population_real over2 = R(1.0) + size2*(R(1.0) + R(0.7)*size2);
        const bicycle_with_accelerometer_population_real part2 = (R(1.0)/(R(1.0) + over2*size2));
        const bicycle_with_accelerometer_population_real size3 = (((-load3)) > (load3) ? (-load3) : load3);
        const bicycle_with_accelerometer_population_real over3 = R(1.0) + size3*(R(1.0) + R(0.7)*size3);
        const bicycle_with_accelerometer_population_real part3 = (R(1.0)/(R(1.0) + over3*size3));
        const bicycle_with_accelerometer_population_real c0 = load0*over0*part0;
        const bicycle_with_accelerometer_population_real c1 = load2*over2*part2;
        const bicycle_with_accelerometer_population_real c2 = config->L*(inv_U*inv_U);
        const bicycle_with_accelerometer_population_real c3 = c2*state->grip;
        const bicycle_with_accelerometer_population_real c4 = c3*inv1;
        const bicycle_with_accelerometer_population_real c5 = load1*over1*part1;
        const bicycle_with_accelerometer_population_real c6 = load3*over3*part3;
        const bicycle_with_accelerometer_population_real c7 = c6*state->pi1;
        const bicycle_with_accelerometer_population_real c8 = c5 - c6;
        const bicycle_with_accelerometer_population_real c9 = c4*c8;
        const bicycle_with_accelerometer_population_real c10 = (part0*part0);
        const bicycle_with_accelerometer_population_real c11 = R(1.0) + size0*(R(2.0) + R(2.1)*size0);
        const bicycle_with_accelerometer_population_real c12 = c10*c11;
        const bicycle_with_accelerometer_population_real c13 = state->eta*(part2*part2)*(R(1.0) + size2*(R(2.0) + R(2.1)*size2));
        const bicycle_with_accelerometer_population_real c14 = R(0.16666666666666666)*h;
        const bicycle_with_accelerometer_population_real c15 = state->K*inv_L;
        const bicycle_with_accelerometer_population_real c16 = c15*inv2;
        const bicycle_with_accelerometer_population_real c17 = c16*c2;
        const bicycle_with_accelerometer_population_real c18 = c13 - c10*c11*inv2*state->pi1;
        const bicycle_with_accelerometer_population_real c19 = c15*c2;
        const bicycle_with_accelerometer_population_real c20 = c19*state->pi1;
        const bicycle_with_accelerometer_population_real c21 = c17*inv1;
        const bicycle_with_accelerometer_population_real c22 = c19*inv1;
        const bicycle_with_accelerometer_population_real c23 = state->v_star_plain + state->pi1*state->r_star_plain;
        const bicycle_with_accelerometer_population_real c24 = c23 - u_plain;
        const bicycle_with_accelerometer_population_real c25 = (part1*part1);
        const bicycle_with_accelerometer_population_real c26 = R(1.0) + size1*(R(2.0) + R(2.1)*size1);
        const bicycle_with_accelerometer_population_real c27 = c25*c26;
        const bicycle_with_accelerometer_population_real c28 = c24*c27;
        const bicycle_with_accelerometer_population_real c29 = (-state->r_star_plain);
        const bicycle_with_accelerometer_population_real c30 = c23 + c29;
        const bicycle_with_accelerometer_population_real c31 = state->eta*(part3*part3)*(R(1.0) + size3*(R(2.0) + R(2.1)*size3));
        const bicycle_with_accelerometer_population_real c32 = c30*c31;
        const bicycle_with_accelerometer_population_real c33 = c28 + c32*state->pi1 - c24*c25*c26*state->pi1;
        const bicycle_with_accelerometer_population_real c34 = c32 - c28;
        const bicycle_with_accelerometer_population_real c35 = (-c5);
        const bicycle_with_accelerometer_population_real c36 = (-c29) - c24*inv2;
        const bicycle_with_accelerometer_population_real c37 = c16*inv0;
        const bicycle_with_accelerometer_population_real c38 = c30*inv2;
        const bicycle_with_accelerometer_population_real c39 = c31*((-c29) - c38);
        const bicycle_with_accelerometer_population_real c40 = c31*c38;
        const bicycle_with_accelerometer_population_real f_v_star = (-state->r_star) - c3*(load0*over0*part0*state->pi1 - c0 - c1*state->pi1); /* rate [-] */
        const bicycle_with_accelerometer_population_real f_r_star = c4*(c0 - c1); /* rate [-] */
        const bicycle_with_accelerometer_population_real f_v_star_plain = (-state->r_star_plain) - c3*(load1*over1*part1*state->pi1 - c5 - c7);
        const bicycle_with_accelerometer_population_real f_r_star_plain = c9;
        const bicycle_with_accelerometer_population_real J_00 = (-c14*c17*(c10*c11*state->pi1 - c12 - c13*state->pi1));
        const bicycle_with_accelerometer_population_real J_01 = (-c14*(R(1.0) + c20*((-c18) - c12*inv2)));
        const bicycle_with_accelerometer_population_real J_10 = c14*c21*(c12 - c13);
        const bicycle_with_accelerometer_population_real J_11 = (-c14*c18*c22);
        const bicycle_with_accelerometer_population_real f_v_star_K = c17*c33;
        const bicycle_with_accelerometer_population_real f_r_star_K = (-c21*c34);
        const bicycle_with_accelerometer_population_real f_v_star_pi1 = (-c3*(state->K*c25*c26*c36*inv0*inv2*inv_L*state->pi1 - c35 - c6 - c27*c36*c37 - c37*c39*state->pi1));
        const bicycle_with_accelerometer_population_real f_r_star_pi1 = c21*(c25*c26*c36 - c39);
        const bicycle_with_accelerometer_population_real f_v_star_eta = c20*c40;
        const bicycle_with_accelerometer_population_real f_r_star_eta = (-c22*c40);
        const bicycle_with_accelerometer_population_real f_v_star_rho = R(0.0);
        const bicycle_with_accelerometer_population_real f_r_star_rho = (-c9);
        const bicycle_with_accelerometer_population_real f_v_star_grip = (-c3*(c35 + c33*c37 + c5*state->pi1 - c7));
        const bicycle_with_accelerometer_population_real f_r_star_grip = c4*(c8 + c34*c37);
        const bicycle_with_accelerometer_population_real f_v_star_place = R(0.0);
        const bicycle_with_accelerometer_population_real f_r_star_place = R(0.0);
        const bicycle_with_accelerometer_population_real f_v_star_u = (-c17*c27*(R(1.0) - state->pi1));
        const bicycle_with_accelerometer_population_real f_r_star_u = (-c21*c27);
        const bicycle_with_accelerometer_population_real p0 = J_00*J_11 - J_01*J_10;
        const bicycle_with_accelerometer_population_real p1 = (-J_00) - J_11;
        const bicycle_with_accelerometer_population_real n0 = R(1.0) - R(1.5)*p0;
        const bicycle_with_accelerometer_population_real n1 = (-R(2.0)) - R(1.5)*p1;
        const bicycle_with_accelerometer_population_real i_det = (R(1.0)/((n0*n0) + p0*(n1*n1) - n0*n1*p1)); /* det N > 0 for every real J */
        const bicycle_with_accelerometer_population_real i0 = i_det*(n0 - n1*p1);
        const bicycle_with_accelerometer_population_real i1 = (-i_det*n1);
        const bicycle_with_accelerometer_population_real E0 = i0 - i1*p0; /* half a step */
        const bicycle_with_accelerometer_population_real E1 = i0 + i1 - i1*p1;
        const bicycle_with_accelerometer_population_real H0 = R(0.5)*h*i0 + R(0.25)*h*i1*p0; /* change per rate over half a step */
        const bicycle_with_accelerometer_population_real H1 = R(0.5)*h*i1 + R(0.25)*h*i1*p1 - R(0.25)*h*i0;
        const bicycle_with_accelerometer_population_real m0 = (E0*E0) - p0*(E1*E1);
        const bicycle_with_accelerometer_population_real m1 = R(2.0)*E0*E1 - p1*(E1*E1);
        const bicycle_with_accelerometer_population_real g0 = H0*(R(1.0) + E0) - E1*H1*p0;
        const bicycle_with_accelerometer_population_real g1 = E1*H0 + H1*(R(1.0) + E0) - E1*H1*p1;
        const bicycle_with_accelerometer_population_real wi0 = (-p0*(R(0.4375) + R(0.1875)*p1));
        const bicycle_with_accelerometer_population_real wi1 = R(0.1875)*p0 - R(0.5) - p1*(R(0.4375) + R(0.1875)*p1);
        const bicycle_with_accelerometer_population_real wh0 = i0*wi0 - i1*p0*wi1;
        const bicycle_with_accelerometer_population_real wh1 = i0*wi1 + i1*wi0 - i1*p1*wi1;
        const bicycle_with_accelerometer_population_real w0 = i0*wh0 - i1*p0*wh1; /* W/h in powers of J */
        const bicycle_with_accelerometer_population_real w1 = i0*wh1 + i1*wh0 - i1*p1*wh1;
        const bicycle_with_accelerometer_population_real M_00 = m0 + J_00*m1; /* dx+/dx */
        const bicycle_with_accelerometer_population_real M_01 = J_01*m1;
        const bicycle_with_accelerometer_population_real M_10 = J_10*m1;
        const bicycle_with_accelerometer_population_real M_11 = m0 + J_11*m1;
        const bicycle_with_accelerometer_population_real G_00 = g0 + J_00*g1; /* change per rate */
        const bicycle_with_accelerometer_population_real G_01 = J_01*g1;
        const bicycle_with_accelerometer_population_real G_10 = J_10*g1;
        const bicycle_with_accelerometer_population_real G_11 = g0 + J_11*g1;
        const bicycle_with_accelerometer_population_real ramp = h*steer_change;
        const bicycle_with_accelerometer_population_real ramp_0 = ramp*w0;
        const bicycle_with_accelerometer_population_real ramp_1 = ramp*w1;
        const bicycle_with_accelerometer_population_real slope1_v_star = J_00*f_v_star_u + J_01*f_r_star_u;
        const bicycle_with_accelerometer_population_real slope1_r_star = J_10*f_v_star_u + J_11*f_r_star_u;
        const bicycle_with_accelerometer_population_real rise_v_star = f_v_star_u*ramp_0 + ramp_1*slope1_v_star; /* the input rises or falls in a straight line [-] */
        const bicycle_with_accelerometer_population_real rise_r_star = f_r_star_u*ramp_0 + ramp_1*slope1_r_star;
        const bicycle_with_accelerometer_population_real d_v_star = rise_v_star + G_00*f_v_star + G_01*f_r_star; /* change over the step [-] */
        const bicycle_with_accelerometer_population_real d_r_star = rise_r_star + G_10*f_v_star + G_11*f_r_star; /* change over the step [-] */
        const bicycle_with_accelerometer_population_real d_v_star_plain = rise_v_star + G_00*f_v_star_plain + G_01*f_r_star_plain;
        const bicycle_with_accelerometer_population_real d_r_star_plain = rise_r_star + G_10*f_v_star_plain + G_11*f_r_star_plain;
        const bicycle_with_accelerometer_population_real F_v_star_K = G_00*f_v_star_K + G_01*f_r_star_K;
        const bicycle_with_accelerometer_population_real F_r_star_K = G_10*f_v_star_K + G_11*f_r_star_K;
        const bicycle_with_accelerometer_population_real F_v_star_pi1 = G_00*f_v_star_pi1 + G_01*f_r_star_pi1;
        const bicycle_with_accelerometer_population_real F_r_star_pi1 = G_10*f_v_star_pi1 + G_11*f_r_star_pi1;
        const bicycle_with_accelerometer_population_real F_v_star_eta = G_00*f_v_star_eta + G_01*f_r_star_eta;
        const bicycle_with_accelerometer_population_real F_r_star_eta = G_10*f_v_star_eta + G_11*f_r_star_eta;
        const bicycle_with_accelerometer_population_real F_v_star_rho = G_00*f_v_star_rho + G_01*f_r_star_rho;
        const bicycle_with_accelerometer_population_real F_r_star_rho = G_10*f_v_star_rho + G_11*f_r_star_rho;
        const bicycle_with_accelerometer_population_real F_v_star_grip = G_00*f_v_star_grip + G_01*f_r_star_grip;
        const bicycle_with_accelerometer_population_real F_r_star_grip = G_10*f_v_star_grip + G_11*f_r_star_grip;
        const bicycle_with_accelerometer_population_real F_v_star_place = G_00*f_v_star_place + G_01*f_r_star_place;
        const bicycle_with_accelerometer_population_real F_r_star_place = G_10*f_v_star_place + G_11*f_r_star_place;
        const bicycle_with_accelerometer_population_real F_v_star_u = G_00*f_v_star_u + G_01*f_r_star_u;
        const bicycle_with_accelerometer_population_real F_r_star_u = G_10*f_v_star_u + G_11*f_r_star_u;
        const bicycle_with_accelerometer_population_real keep_w = ((R(0.0)) > (R(1.0) - config->disturbance_rate*sample->dt) ? R(0.0) : R(1.0) - config->disturbance_rate*sample->dt);
        const bicycle_with_accelerometer_population_real w_nominal = (config->disturbance_floor*config->disturbance_floor) + state->activity*(config->disturbance_share*config->disturbance_share)*(inv_output_scale*inv_output_scale); /* nominal variance of the disturbance */
        move = R(0.0);
        diffusion = config->drift + config->faint_drift*((R(0.0)) > (R(1.0) - state->heard*config->inv_telling) ? R(0.0) : R(1.0) - state->heard*config->inv_telling); /* a jump that could not have shown may have come */
        if (state->excited < R(0.5)) { /* nothing heard: it may have changed, and the population is the best guess */
            const bicycle_with_accelerometer_population_real lost = ((R(1.0)) < (R(0.5)*sample->dt*config->idle_drift*config->prior_information) ? R(1.0) : R(0.5)*sample->dt*config->idle_drift*config->prior_information);
            const bicycle_with_accelerometer_population_real keep = R(1.0) - lost;
            diffusion = lost*(R(1.0) + keep)/(sample->dt*config->prior_information); /* for long: the prior variance */
            P[3] = P[3]*keep;
            P[15] = P[15]*keep;
            P[26] = P[26]*keep;
            P[36] = P[36]*keep;
            P[37] = P[37]*keep;
            P[38] = P[38]*keep;
            P[39] = P[39]*keep;
            P[40] = P[40]*keep;
            P[41] = P[41]*keep;
            P[42] = P[42]*keep;
            P[43] = P[43]*keep;
            P[44] = P[44]*keep;
            P[45] = P[45]*keep;
            P[36] = P[36]*keep;
            const bicycle_with_accelerometer_population_real p = state->K - config->K_prior;
            const bicycle_with_accelerometer_population_real q = state->K + config->K_prior;
            const bicycle_with_accelerometer_population_real pp = (p*p);
            const bicycle_with_accelerometer_population_real qq = (q*q);
            const bicycle_with_accelerometer_population_real away = R(2.0)*p*(R(15.0)*qq - R(4.0)*pp)/(q*(R(15.0)*qq - R(9.0)*pp)); /* ln(K/K_prior) */
            move = (-away*lost);
        }
        const bicycle_with_accelerometer_population_real F_v_star_v_star = M_00*ratio_v_star;
        const bicycle_with_accelerometer_population_real F_v_star_r_star = M_01*ratio_r_star;
        const bicycle_with_accelerometer_population_real F_r_star_v_star = M_10*ratio_v_star;
        const bicycle_with_accelerometer_population_real F_r_star_r_star = M_11*ratio_r_star;
        bicycle_with_accelerometer_population_propagate(config, state, sample, steer, F_v_star_K, F_v_star_eta, F_v_star_grip, F_v_star_pi1, F_v_star_place, F_v_star_r_star, F_v_star_rho, F_v_star_u, F_v_star_v_star, F_r_star_K, F_r_star_eta, F_r_star_grip, F_r_star_pi1, F_r_star_place, F_r_star_r_star, F_r_star_rho, F_r_star_u, F_r_star_v_star, keep_w, w_nominal, diffusion);
        state->disturbance = state->disturbance*keep_w;
        state->v_star = d_v_star + state->v_star;
        state->r_star = d_r_star + state->r_star;
        const bicycle_with_accelerometer_population_real follow = ((R(1.0)) < (config->companion_rate*sample->dt) ? R(1.0) : config->companion_rate*sample->dt);
        state->input_offset_plain = state->input_offset_plain + (state->input_offset - state->input_offset_plain)*((R(1.0)) < (sample->dt*config->offset_rate) ? R(1.0) : sample->dt*config->offset_rate);
        state->v_star_plain = d_v_star_plain + state->v_star_plain + follow*(state->v_star - d_v_star_plain - state->v_star_plain);
        state->r_star_plain = d_r_star_plain + state->r_star_plain + follow*(state->r_star - d_r_star_plain - state->r_star_plain);
        const bicycle_with_accelerometer_population_real response = output_scale*state->r_star; /* output of the model */
        predicted = state->output_bias + response;
        const bicycle_with_accelerometer_population_real output_rate = d_r_star*inv_dt*output_scale;
        state->activity = state->activity + ((response*response) - state->activity)*((R(1.0)) < (config->activity_rate*sample->dt) ? R(1.0) : config->activity_rate*sample->dt);
        const bicycle_with_accelerometer_population_real noise = state->noise_scale*(config->noise_variance + (output_rate*output_rate)*(config->timing_error*config->timing_error) + state->activity*(config->structure_share*config->structure_share)*((R(1.0)) > (R(2.0)*inv_dt*config->structure_time) ? R(1.0) : R(2.0)*inv_dt*config->structure_time)); /* variance of the measurement */
        const bicycle_with_accelerometer_population_real validity_now = inv_L*state->r_star*(at_U*at_U); /* lateral acceleration */
        const bicycle_with_accelerometer_population_real validity_then = state->validity*(R(1.0) - ((R(1.0)) < (sample->dt*config->validity_rate) ? R(1.0) : sample->dt*config->validity_rate));
        const bicycle_with_accelerometer_population_real validity_square = (validity_now*validity_now);
        state->validity = ((validity_square) > (validity_then) ? validity_square : validity_then);
        if (usable > 0) { /* measurement */
            const bicycle_with_accelerometer_population_real c_1 = P[23] + P[13]*output_scale;
            const bicycle_with_accelerometer_population_real c_3 = P[44] + P[15]*output_scale;
            const bicycle_with_accelerometer_population_real c_11 = P[88] + P[23]*output_scale;
            innovation = sample->measured - predicted;
            innovation_variance = c_11 + noise + c_1*output_scale;
            inv_spread = (R(1.0)/innovation_variance);
            const bicycle_with_accelerometer_population_real nis = inv_spread*(innovation*innovation); /* normalised innovation squared */
            if (nis > config->outlier_ratio) { /* an outlier counts for less */
                inv_spread = inv_spread*config->outlier_ratio/nis;
            }
            const bicycle_with_accelerometer_population_real inv_P = (R(1.0)/P[36]);
            const bicycle_with_accelerometer_population_real sensitivity = c_3*inv_P; /* of the output to ln K */
            state->excitation = state->excitation + ((sensitivity*sensitivity) - state->excitation)*((R(1.0)) < (sample->dt*config->excitation_rate) ? R(1.0) : sample->dt*config->excitation_rate);
            state->excited = (state->excitation > config->excitation_ratio*noise ? R(1.0) : R(0.0));
            const bicycle_with_accelerometer_population_real linear = (state->validity < (config->validity_limit*config->validity_limit) ? R(1.0) : R(0.0)); /* 1 in the model's linear range */
            const bicycle_with_accelerometer_population_real odd = ((R(9.0)) < (nis) ? R(9.0) : nis) - R(1.0); /* by how much it is not as expected */
            state->surprise = state->surprise + (R(1.0) + linear*odd - state->surprise)*((R(1.0)) < (sample->dt*config->surprise_rate) ? R(1.0) : sample->dt*config->surprise_rate); /* recent mean of the normalised innovation squared */
            const bicycle_with_accelerometer_population_real learn_beyond = state->excited*inv_spread;
            state->untaught = sample->dt + state->untaught;
            const bicycle_with_accelerometer_population_real learn = ((config->beyond_time <= state->untaught) || (linear > R(0.5)) ? state->excited*inv_spread : R(0.0)); /* its error there lasts */
            if (learn > R(0.0)) {
                state->untaught = R(0.0);
            }
            state->heard = state->heard*(R(1.0) - ((R(1.0)) < (sample->dt*config->heard_rate) ? R(1.0) : sample->dt*config->heard_rate)) + inv_spread*(sensitivity*sensitivity); /* information of late */
            const bicycle_with_accelerometer_population_real above = state->surprise - R(1.0);
            state->restlessness = state->restlessness + ((above*above) - state->restlessness)*((R(1.0)) < (sample->dt*config->noise_adapt) ? R(1.0) : sample->dt*config->noise_adapt);
            const bicycle_with_accelerometer_population_real rise = ((above*above) > config->jump_ratio*state->restlessness ? state->surprise - config->surprise_limit : R(0.0));
            state->jump = ((R(0.0)) > (rise) ? R(0.0) : rise);
            const bicycle_with_accelerometer_population_real learn_slow = (state->jump <= R(0.0) ? learn : R(0.0)); /* a jump is not blamed on what cannot jump */
            state->unlearnt = sample->dt + state->unlearnt;
            const bicycle_with_accelerometer_population_real learn_seldom = (config->seldom <= state->unlearnt ? learn_slow : R(0.0)); /* the next sample tells little that this one does not */
            if (learn_seldom > R(0.0)) {
                state->unlearnt = R(0.0);
            }
            const bicycle_with_accelerometer_population_real gain_3 = c_3*learn;
            const bicycle_with_accelerometer_population_real gained = c_3*gain_3*inv_P; /* share of the variance removed */
            state->information = state->information + gained*inv_P*(R(1.0) + gained); /* 1/variance gained */
            move = move + gain_3*innovation;
            bicycle_with_accelerometer_population_correct(state, output_scale, inv_spread, c_1, learn_seldom, learn_slow, learn_beyond, c_11, c_3, gain_3, innovation);
            state->settling = ((config->noise_adapt) > (state->settling - sample->dt*(state->settling*state->settling)) ? config->noise_adapt : state->settling - sample->dt*(state->settling*state->settling)); /* 1/time at first */
            const bicycle_with_accelerometer_population_real noise_change = odd*((R(0.05)) < (sample->dt*state->settling) ? R(0.05) : sample->dt*state->settling);
            state->noise_scale = state->noise_scale*(R(1.0) + noise_change*(R(1.0) + noise_change*(R(0.5) + R(0.16666666666666666)*noise_change)));
            state->noise_scale = ((state->noise_scale) > (config->noise_scale_low) ? state->noise_scale : config->noise_scale_low);
            state->noise_scale = ((state->noise_scale) < (config->noise_scale_high) ? state->noise_scale : config->noise_scale_high);
            const bicycle_with_accelerometer_population_real expected = state->disturbance_scale*w_nominal; /* disturbance variance expected */
            const bicycle_with_accelerometer_population_real seen = ((R(9.0)*expected) < (P[25] + (state->disturbance*state->disturbance)) ? R(9.0)*expected : P[25] + (state->disturbance*state->disturbance)); /* and seen */
            const bicycle_with_accelerometer_population_real unseen = ((expected*config->observed_least) > (expected - P[25]) ? expected*config->observed_least : expected - P[25]);
            state->disturbance_scale = state->disturbance_scale + state->disturbance_scale*(seen - expected)*((R(1.0)) < (config->disturbance_adapt*sample->dt) ? R(1.0) : config->disturbance_adapt*sample->dt)/unseen;
            state->disturbance_scale = ((state->disturbance_scale) > (config->disturbance_scale_low) ? state->disturbance_scale : config->disturbance_scale_low);
            state->disturbance_scale = ((state->disturbance_scale) < (config->disturbance_scale_high) ? state->disturbance_scale : config->disturbance_scale_high);
            if ((state->excited < R(0.5)) && (status < 1)) {
                status = 1;
            }
            if ((state->validity > (config->validity_limit*config->validity_limit)) && (status < 2)) {
                status = 2;
            }
            if (WITHIN(sample->ay_measured, config->ay_limit)) { /* ay is measured too */
                const bicycle_with_accelerometer_population_real ay_scale = inv_L*(at_U*at_U); /* ay = scale x dimensionless */
                const bicycle_with_accelerometer_population_real ay_u = state->disturbance + state->input_offset + state->input_scale*u_now; /* effective input at the end [-] */
                const bicycle_with_accelerometer_population_real ay_u_plain = state->input_scale*u_now;
                const bicycle_with_accelerometer_population_real ay_s0 = state->v_star + state->pi1*state->r_star;
                const bicycle_with_accelerometer_population_real ay_s1 = ay_s0 - ay_u;
                const bicycle_with_accelerometer_population_real ay_s2 = (R(1.0)/(state->pi1 - R(1.0)));
                const bicycle_with_accelerometer_population_real ay_s3 = state->K*inv_L;
                const bicycle_with_accelerometer_population_real ay_s4 = ay_s3/state->grip;
                const bicycle_with_accelerometer_population_real ay_s5 = ay_s2*ay_s4;
                const bicycle_with_accelerometer_population_real ay_s6 = ay_s1*ay_s5;
                const bicycle_with_accelerometer_population_real ay_s7 = (((-ay_s6)) > (ay_s6) ? (-ay_s6) : ay_s6);
                const bicycle_with_accelerometer_population_real ay_s8 = R(10.0) + ay_s7*(R(10.0) + R(7.0)*ay_s7);
                const bicycle_with_accelerometer_population_real ay_s9 = R(10.0) + ay_s7*ay_s8;
                const bicycle_with_accelerometer_population_real ay_s10 = (R(1.0)/ay_s9);
                const bicycle_with_accelerometer_population_real ay_s11 = ay_s1*ay_s10*ay_s8;
                const bicycle_with_accelerometer_population_real ay_s12 = state->eta*(ay_s0 - state->r_star);
                const bicycle_with_accelerometer_population_real ay_s13 = ay_s12*ay_s5;
                const bicycle_with_accelerometer_population_real ay_s14 = (((-ay_s13)) > (ay_s13) ? (-ay_s13) : ay_s13);
                const bicycle_with_accelerometer_population_real ay_s15 = R(10.0) + ay_s14*(R(10.0) + R(7.0)*ay_s14);
                const bicycle_with_accelerometer_population_real ay_s16 = R(10.0) + ay_s14*ay_s15;
                const bicycle_with_accelerometer_population_real ay_s17 = ay_s12*ay_s15/ay_s16;
                const bicycle_with_accelerometer_population_real ay_s18 = (R(1.0)/state->rho);
                const bicycle_with_accelerometer_population_real ay_s19 = state->pi1 - state->place;
                const bicycle_with_accelerometer_population_real ay_s20 = ay_s18*ay_s19;
                const bicycle_with_accelerometer_population_real ay_s21 = config->L*ay_s3*ay_scale*(inv_U*inv_U);
                const bicycle_with_accelerometer_population_real ay_s22 = ay_s2*ay_s21;
                const bicycle_with_accelerometer_population_real ay_s23 = R(10.0) + ay_s7*(R(20.0) + R(21.0)*ay_s7);
                const bicycle_with_accelerometer_population_real ay_s24 = (R(1.0)/(ay_s9*ay_s9));
                const bicycle_with_accelerometer_population_real ay_s25 = ay_s23*ay_s24;
                const bicycle_with_accelerometer_population_real ay_s26 = state->eta*(R(10.0) + ay_s14*(R(20.0) + R(21.0)*ay_s14))/((ay_s16*ay_s16));
                const bicycle_with_accelerometer_population_real ay_s27 = R(10.0)*ay_s22;
                const bicycle_with_accelerometer_population_real ay_s28 = ay_s26 - ay_s2*ay_s23*ay_s24*state->pi1;
                const bicycle_with_accelerometer_population_real ay_s29 = ay_s2*ay_s25;
                const bicycle_with_accelerometer_population_real ay_s30 = R(10.0)*ay_s21;
                const bicycle_with_accelerometer_population_real ay_s31 = state->v_star_plain + state->pi1*state->r_star_plain;
                const bicycle_with_accelerometer_population_real ay_s32 = ay_s31 - ay_u_plain;
                const bicycle_with_accelerometer_population_real ay_s33 = ay_s2*ay_s32;
                const bicycle_with_accelerometer_population_real ay_s34 = ay_s33*ay_s4;
                const bicycle_with_accelerometer_population_real ay_s35 = (((-ay_s34)) > (ay_s34) ? (-ay_s34) : ay_s34);
                const bicycle_with_accelerometer_population_real ay_s36 = R(10.0) + ay_s35*(R(10.0) + R(7.0)*ay_s35);
                const bicycle_with_accelerometer_population_real ay_s37 = R(10.0) + ay_s35*ay_s36;
                const bicycle_with_accelerometer_population_real ay_s38 = (R(1.0)/(ay_s37*ay_s37));
                const bicycle_with_accelerometer_population_real ay_s39 = R(10.0) + ay_s35*(R(20.0) + R(21.0)*ay_s35);
                const bicycle_with_accelerometer_population_real ay_s40 = ay_s38*ay_s39;
                const bicycle_with_accelerometer_population_real ay_s41 = ay_s32*ay_s40;
                const bicycle_with_accelerometer_population_real ay_s42 = ay_s41*state->pi1;
                const bicycle_with_accelerometer_population_real ay_s43 = ay_s31 - state->r_star_plain;
                const bicycle_with_accelerometer_population_real ay_s44 = ay_s43*state->eta;
                const bicycle_with_accelerometer_population_real ay_s45 = ay_s2*ay_s43;
                const bicycle_with_accelerometer_population_real ay_s46 = ay_s4*ay_s45*state->eta;
                const bicycle_with_accelerometer_population_real ay_s47 = (((-ay_s46)) > (ay_s46) ? (-ay_s46) : ay_s46);
                const bicycle_with_accelerometer_population_real ay_s48 = R(10.0) + ay_s47*(R(10.0) + R(7.0)*ay_s47);
                const bicycle_with_accelerometer_population_real ay_s49 = R(10.0) + ay_s47*ay_s48;
                const bicycle_with_accelerometer_population_real ay_s50 = (R(10.0) + ay_s47*(R(20.0) + R(21.0)*ay_s47))/((ay_s49*ay_s49));
                const bicycle_with_accelerometer_population_real ay_s51 = ay_s44*ay_s50;
                const bicycle_with_accelerometer_population_real ay_s52 = ay_s51*state->pi1;
                const bicycle_with_accelerometer_population_real ay_s53 = ay_s51 - ay_s32*ay_s38*ay_s39;
                const bicycle_with_accelerometer_population_real ay_s54 = ay_s32*ay_s36/ay_s37;
                const bicycle_with_accelerometer_population_real ay_s55 = ay_s44*ay_s48/ay_s49;
                const bicycle_with_accelerometer_population_real ay_s56 = ay_s55 - ay_s54;
                const bicycle_with_accelerometer_population_real ay_s57 = (-ay_s18*ay_s56);
                const bicycle_with_accelerometer_population_real ay_s58 = state->r_star_plain - ay_s33;
                const bicycle_with_accelerometer_population_real ay_s59 = ay_s50*state->eta;
                const bicycle_with_accelerometer_population_real ay_s60 = ay_s59*(state->r_star_plain - ay_s45);
                const bicycle_with_accelerometer_population_real ay_s61 = R(10.0)*ay_s20;
                const bicycle_with_accelerometer_population_real ay_s62 = R(10.0)*ay_s40*ay_s58;
                const bicycle_with_accelerometer_population_real ay_s63 = ay_s19*ay_s57;
                const bicycle_with_accelerometer_population_real ay_response = ay_s22*(ay_s11 + ay_s17*state->pi1 + ay_s20*(ay_s1*ay_s10*ay_s8 - ay_s17) - ay_s11*state->pi1);
                const bicycle_with_accelerometer_population_real ay_by_v_star = ay_s27*(ay_s25 + ay_s20*(ay_s23*ay_s24 - ay_s26) + ay_s26*state->pi1 - ay_s25*state->pi1);
                const bicycle_with_accelerometer_population_real ay_by_r_star = ay_s30*((-state->pi1*((-ay_s28) - ay_s29)) - ay_s18*ay_s19*ay_s28);
                const bicycle_with_accelerometer_population_real ay_by_K = ay_s27*(ay_s41 + ay_s52 - ay_s42 - ay_s20*ay_s53);
                const bicycle_with_accelerometer_population_real ay_by_pi1 = ay_s22*(ay_s56 + ay_s57 + ay_s62 + R(10.0)*ay_s60*state->pi1 + ay_s61*(ay_s38*ay_s39*ay_s58 - ay_s60) - ay_s62*state->pi1);
                const bicycle_with_accelerometer_population_real ay_by_eta = ay_s30*ay_s45*ay_s59*(state->pi1 - ay_s20);
                const bicycle_with_accelerometer_population_real ay_by_rho = (-ay_s22*ay_s63);
                const bicycle_with_accelerometer_population_real ay_by_grip = ay_s22*(R(10.0)*ay_s42 + ay_s54 + ay_s63 + ay_s53*ay_s61 + ay_s55*state->pi1 - R(10.0)*ay_s41 - R(10.0)*ay_s52 - ay_s54*state->pi1);
                const bicycle_with_accelerometer_population_real ay_by_place = (-ay_s22*ay_s57);
                const bicycle_with_accelerometer_population_real ay_by_u = (-ay_s29*ay_s30*(R(1.0) + ay_s20 - state->pi1));
                state->ay_activity = state->ay_activity + ((ay_response*ay_response) - state->ay_activity)*((R(1.0)) < (config->activity_rate*sample->dt) ? R(1.0) : config->activity_rate*sample->dt);
                const bicycle_with_accelerometer_population_real ay_noise = state->ay_noise_scale*(config->ay_variance + state->ay_activity*(config->ay_share*config->ay_share))*((R(1.0)) > (R(2.0)*config->ay_time*inv_dt) ? R(1.0) : R(2.0)*config->ay_time*inv_dt); /* variance of ay */
                const bicycle_with_accelerometer_population_real ay_c_0 = (P[12] + P[0]*ay_by_v_star + P[1]*ay_by_r_star + P[10]*ay_by_u + P[2]*ay_by_u + P[3]*ay_by_K) + (P[4]*ay_by_pi1 + P[5]*ay_by_eta + P[6]*ay_by_rho + P[7]*ay_by_grip + P[8]*ay_by_place + P[9]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_1 = (P[24] + P[1]*ay_by_v_star + P[13]*ay_by_r_star + P[14]*ay_by_u + P[15]*ay_by_K + P[16]*ay_by_pi1) + (P[17]*ay_by_eta + P[18]*ay_by_rho + P[19]*ay_by_grip + P[20]*ay_by_place + P[22]*ay_by_u + P[21]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_2 = (P[35] + P[14]*ay_by_r_star + P[2]*ay_by_v_star + P[25]*ay_by_u + P[26]*ay_by_K + P[27]*ay_by_pi1) + (P[28]*ay_by_eta + P[29]*ay_by_rho + P[30]*ay_by_grip + P[31]*ay_by_place + P[33]*ay_by_u + P[32]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_3 = (P[45] + P[15]*ay_by_r_star + P[26]*ay_by_u + P[3]*ay_by_v_star + P[36]*ay_by_K + P[37]*ay_by_pi1) + (P[38]*ay_by_eta + P[39]*ay_by_rho + P[40]*ay_by_grip + P[41]*ay_by_place + P[43]*ay_by_u + P[42]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_4 = (P[54] + P[16]*ay_by_r_star + P[27]*ay_by_u + P[37]*ay_by_K + P[4]*ay_by_v_star + P[46]*ay_by_pi1) + (P[47]*ay_by_eta + P[48]*ay_by_rho + P[49]*ay_by_grip + P[50]*ay_by_place + P[52]*ay_by_u + P[51]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_5 = (P[62] + P[17]*ay_by_r_star + P[28]*ay_by_u + P[38]*ay_by_K + P[47]*ay_by_pi1 + P[5]*ay_by_v_star) + (P[55]*ay_by_eta + P[56]*ay_by_rho + P[57]*ay_by_grip + P[58]*ay_by_place + P[60]*ay_by_u + P[59]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_6 = (P[69] + P[18]*ay_by_r_star + P[29]*ay_by_u + P[39]*ay_by_K + P[48]*ay_by_pi1 + P[56]*ay_by_eta) + (P[6]*ay_by_v_star + P[63]*ay_by_rho + P[64]*ay_by_grip + P[65]*ay_by_place + P[67]*ay_by_u + P[66]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_7 = (P[75] + P[19]*ay_by_r_star + P[30]*ay_by_u + P[40]*ay_by_K + P[49]*ay_by_pi1 + P[57]*ay_by_eta) + (P[64]*ay_by_rho + P[7]*ay_by_v_star + P[70]*ay_by_grip + P[71]*ay_by_place + P[73]*ay_by_u + P[72]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_8 = (P[80] + P[20]*ay_by_r_star + P[31]*ay_by_u + P[41]*ay_by_K + P[50]*ay_by_pi1 + P[58]*ay_by_eta) + (P[65]*ay_by_rho + P[71]*ay_by_grip + P[76]*ay_by_place + P[78]*ay_by_u + P[8]*ay_by_v_star + P[77]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_9 = (P[84] + P[21]*ay_by_r_star + P[32]*ay_by_u + P[42]*ay_by_K + P[51]*ay_by_pi1 + P[59]*ay_by_eta) + (P[66]*ay_by_rho + P[72]*ay_by_grip + P[77]*ay_by_place + P[82]*ay_by_u + P[9]*ay_by_v_star + P[81]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_10 = (P[87] + P[10]*ay_by_v_star + P[22]*ay_by_r_star + P[33]*ay_by_u + P[43]*ay_by_K + P[52]*ay_by_pi1) + (P[60]*ay_by_eta + P[67]*ay_by_rho + P[73]*ay_by_grip + P[78]*ay_by_place + P[85]*ay_by_u + P[82]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_c_12 = (P[90] + P[12]*ay_by_v_star + P[24]*ay_by_r_star + P[35]*ay_by_u + P[45]*ay_by_K + P[54]*ay_by_pi1) + (P[62]*ay_by_eta + P[69]*ay_by_rho + P[75]*ay_by_grip + P[80]*ay_by_place + P[87]*ay_by_u + P[84]*ay_by_u*state->input_scale*u_now);
                const bicycle_with_accelerometer_population_real ay_innovation = sample->ay_measured - state->ay_bias - ay_response - ay_by_K*move;
                ay_inv_spread = (R(1.0)/((ay_c_12 + ay_noise + ay_by_K*ay_c_3 + ay_by_eta*ay_c_5 + ay_by_grip*ay_c_7 + ay_by_pi1*ay_c_4) + (ay_by_place*ay_c_8 + ay_by_r_star*ay_c_1 + ay_by_rho*ay_c_6 + ay_by_u*ay_c_10 + ay_by_u*ay_c_2 + ay_by_v_star*ay_c_0 + ay_by_u*ay_c_9*state->input_scale*u_now)));
                const bicycle_with_accelerometer_population_real ay_nis = ay_inv_spread*(ay_innovation*ay_innovation); /* normalised innovation squared */
                if (ay_nis > config->outlier_ratio) { /* an outlier counts for less */
                    ay_inv_spread = ay_inv_spread*config->outlier_ratio/ay_nis;
                }
                const bicycle_with_accelerometer_population_real ay_learn_beyond = (learn_beyond > R(0.0) ? ay_inv_spread : R(0.0)); /* where the first may learn */
                const bicycle_with_accelerometer_population_real ay_learn = (learn > R(0.0) ? ay_inv_spread : R(0.0)); /* where the first may learn */
                const bicycle_with_accelerometer_population_real ay_learn_slow = (learn_slow > R(0.0) ? ay_inv_spread : R(0.0)); /* where the first may learn */
                const bicycle_with_accelerometer_population_real ay_learn_seldom = (learn_seldom > R(0.0) ? ay_inv_spread : R(0.0)); /* where the first may learn */
                const bicycle_with_accelerometer_population_real ay_gain_3 = ay_c_3*ay_learn;
                const bicycle_with_accelerometer_population_real ay_inv_P = (R(1.0)/P[36]);
                const bicycle_with_accelerometer_population_real ay_gained = ay_c_3*ay_gain_3*ay_inv_P; /* share of the variance removed */
                state->information = state->information + ay_gained*ay_inv_P*(R(1.0) + ay_gained);
                move = move + ay_gain_3*ay_innovation;
                bicycle_with_accelerometer_population_correct_by_ay(state, ay_by_K, ay_by_eta, ay_by_grip, ay_by_pi1, ay_by_place, ay_by_r_star, ay_by_rho, ay_by_u, ay_by_v_star, u_now, ay_c_0, ay_inv_spread, ay_c_1, ay_c_2, ay_c_4, ay_learn_seldom, ay_c_5, ay_learn_slow, ay_c_6, ay_c_7, ay_learn_beyond, ay_c_8, ay_c_9, ay_c_10, ay_c_12, ay_c_3, ay_gain_3, ay_innovation);
                const bicycle_with_accelerometer_population_real ay_noise_change = (((R(9.0)) < (ay_nis) ? R(9.0) : ay_nis) - R(1.0))*((R(0.05)) < (sample->dt*state->settling) ? R(0.05) : sample->dt*state->settling);
                state->ay_noise_scale = state->ay_noise_scale*(R(1.0) + ay_noise_change*(R(1.0) + ay_noise_change*(R(0.5) + R(0.16666666666666666)*ay_noise_change)));
                state->ay_noise_scale = ((state->ay_noise_scale) > (config->ay_noise_scale_low) ? state->ay_noise_scale : config->ay_noise_scale_low);
                state->ay_noise_scale = ((state->ay_noise_scale) < (config->ay_noise_scale_high) ? state->ay_noise_scale : config->ay_noise_scale_high);
            }
        }
        const bicycle_with_accelerometer_population_real above_move = (((-R(1.0))) > (move) ? (-R(1.0)) : move);
        const bicycle_with_accelerometer_population_real bounded_move = ((R(1.0)) < (above_move) ? R(1.0) : above_move);
        state->K = state->K*(R(1.0) + bounded_move*(R(1.0) + bounded_move*(R(0.5) + R(0.16666666666666666)*bounded_move)));
        if ((state->K < config->K_low) || (state->K > config->K_high) || (state->eta < config->eta_low) || (state->eta > config->eta_high) || (state->grip < config->grip_low) || (state->grip > config->grip_high) || (state->input_scale < config->input_scale_low) || (state->input_scale > config->input_scale_high) || (state->pi1 < config->pi1_low) || (state->pi1 > config->pi1_high) || (state->place < config->place_low) || (state->place > config->place_high) || (state->rho < config->rho_low) || (state->rho > config->rho_high)) { /* prior +- its allowed range */
            state->K = ((config->K_high) < (((state->K) > (config->K_low) ? state->K : config->K_low)) ? config->K_high : ((state->K) > (config->K_low) ? state->K : config->K_low));
            state->pi1 = ((config->pi1_high) < (((state->pi1) > (config->pi1_low) ? state->pi1 : config->pi1_low)) ? config->pi1_high : ((state->pi1) > (config->pi1_low) ? state->pi1 : config->pi1_low));
            state->eta = ((config->eta_high) < (((state->eta) > (config->eta_low) ? state->eta : config->eta_low)) ? config->eta_high : ((state->eta) > (config->eta_low) ? state->eta : config->eta_low));
            state->rho = ((config->rho_high) < (((state->rho) > (config->rho_low) ? state->rho : config->rho_low)) ? config->rho_high : ((state->rho) > (config->rho_low) ? state->rho : config->rho_low));
            state->grip = ((config->grip_high) < (((state->grip) > (config->grip_low) ? state->grip : config->grip_low)) ? config->grip_high : ((state->grip) > (config->grip_low) ? state->grip : config->grip_low));
            state->place = ((config->place_high) < (((state->place) > (config->place_low) ? state->place : config->place_low)) ? config->place_high : ((state->place) > (config->place_low) ? state->place : config->place_low));
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
    own_variance = P[36];
    const bicycle_with_accelerometer_population_real pivot_5 = P[55];
    const bicycle_with_accelerometer_population_real inv_pivot_5 = (R(1.0)/((pivot_5) > (R(1e-24) + R(1e-06)*P[55]) ? pivot_5 : R(1e-24) + R(1e-06)*P[55]));
    const bicycle_with_accelerometer_population_real lean_5 = P[38];
    const bicycle_with_accelerometer_population_real row_5_6 = P[56];
    const bicycle_with_accelerometer_population_real ratio_5_6 = inv_pivot_5*row_5_6;
    const bicycle_with_accelerometer_population_real row_5_7 = P[57];
    const bicycle_with_accelerometer_population_real ratio_5_7 = inv_pivot_5*row_5_7;
    const bicycle_with_accelerometer_population_real row_5_8 = P[58];
    const bicycle_with_accelerometer_population_real ratio_5_8 = inv_pivot_5*row_5_8;
    const bicycle_with_accelerometer_population_real row_5_9 = P[59];
    const bicycle_with_accelerometer_population_real ratio_5_9 = inv_pivot_5*row_5_9;
    const bicycle_with_accelerometer_population_real pivot_6 = P[63] - ratio_5_6*row_5_6;
    const bicycle_with_accelerometer_population_real inv_pivot_6 = (R(1.0)/((pivot_6) > (R(1e-24) + R(1e-06)*P[63]) ? pivot_6 : R(1e-24) + R(1e-06)*P[63]));
    const bicycle_with_accelerometer_population_real lean_6 = P[39] - lean_5*ratio_5_6;
    const bicycle_with_accelerometer_population_real row_6_7 = P[64] - ratio_5_6*row_5_7;
    const bicycle_with_accelerometer_population_real ratio_6_7 = inv_pivot_6*row_6_7;
    const bicycle_with_accelerometer_population_real row_6_8 = P[65] - ratio_5_6*row_5_8;
    const bicycle_with_accelerometer_population_real ratio_6_8 = inv_pivot_6*row_6_8;
    const bicycle_with_accelerometer_population_real row_6_9 = P[66] - ratio_5_6*row_5_9;
    const bicycle_with_accelerometer_population_real ratio_6_9 = inv_pivot_6*row_6_9;
    const bicycle_with_accelerometer_population_real pivot_7 = P[70] - ratio_5_7*row_5_7 - ratio_6_7*row_6_7;
    const bicycle_with_accelerometer_population_real inv_pivot_7 = (R(1.0)/((pivot_7) > (R(1e-24) + R(1e-06)*P[70]) ? pivot_7 : R(1e-24) + R(1e-06)*P[70]));
    const bicycle_with_accelerometer_population_real lean_7 = P[40] - lean_5*ratio_5_7 - lean_6*ratio_6_7;
    const bicycle_with_accelerometer_population_real row_7_8 = P[71] - ratio_5_7*row_5_8 - ratio_6_7*row_6_8;
    const bicycle_with_accelerometer_population_real ratio_7_8 = inv_pivot_7*row_7_8;
    const bicycle_with_accelerometer_population_real row_7_9 = P[72] - ratio_5_7*row_5_9 - ratio_6_7*row_6_9;
    const bicycle_with_accelerometer_population_real ratio_7_9 = inv_pivot_7*row_7_9;
    const bicycle_with_accelerometer_population_real pivot_8 = P[76] - ratio_5_8*row_5_8 - ratio_6_8*row_6_8 - ratio_7_8*row_7_8;
    const bicycle_with_accelerometer_population_real inv_pivot_8 = (R(1.0)/((pivot_8) > (R(1e-24) + R(1e-06)*P[76]) ? pivot_8 : R(1e-24) + R(1e-06)*P[76]));
    const bicycle_with_accelerometer_population_real lean_8 = P[41] - lean_5*ratio_5_8 - lean_6*ratio_6_8 - lean_7*ratio_7_8;
    const bicycle_with_accelerometer_population_real row_8_9 = P[77] - ratio_5_8*row_5_9 - ratio_6_8*row_6_9 - ratio_7_8*row_7_9;
    const bicycle_with_accelerometer_population_real ratio_8_9 = inv_pivot_8*row_8_9;
    const bicycle_with_accelerometer_population_real pivot_9 = P[81] - ratio_5_9*row_5_9 - ratio_6_9*row_6_9 - ratio_7_9*row_7_9 - ratio_8_9*row_8_9;
    const bicycle_with_accelerometer_population_real inv_pivot_9 = (R(1.0)/((pivot_9) > (R(1e-24) + R(1e-06)*P[81]) ? pivot_9 : R(1e-24) + R(1e-06)*P[81]));
    const bicycle_with_accelerometer_population_real lean_9 = P[42] - lean_5*ratio_5_9 - lean_6*ratio_6_9 - lean_7*ratio_7_9 - lean_8*ratio_8_9;
    const bicycle_with_accelerometer_population_real leant = inv_pivot_5*(lean_5*lean_5) + inv_pivot_6*(lean_6*lean_6) + inv_pivot_7*(lean_7*lean_7) + inv_pivot_8*(lean_8*lean_8) + inv_pivot_9*(lean_9*lean_9); /* of it, what would go if the constants were known */
    variance = P[36] + config->slow_doubt*((P[36]) < (leant) ? P[36] : leant);
    information_gained = state->information;
    pi1_now = state->pi1;
    eta_now = state->eta;
    rho_now = state->rho;
    grip_now = state->grip;
    place_now = state->place;
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
    output->place_now = place_now;
    output->offset_now = offset_now;
    output->bias_now = bias_now;
    output->noise_now = noise_now;
    output->disturbance_now = disturbance_now;
    return status;
}

/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int bicycle_with_accelerometer_population_step(const bicycle_with_accelerometer_population_config *config, bicycle_with_accelerometer_population_state *state,
                               const bicycle_with_accelerometer_population_sample *sample, bicycle_with_accelerometer_population_output *output)
{
    return bicycle_with_accelerometer_population_advance(config, state, sample, output);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long bicycle_with_accelerometer_population_batch(const bicycle_with_accelerometer_population_config *config, bicycle_with_accelerometer_population_state *state, long n,
                                 const bicycle_with_accelerometer_population_sample *samples, bicycle_with_accelerometer_population_output *outputs, int *status)
{
    bicycle_with_accelerometer_population_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = bicycle_with_accelerometer_population_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}
