/* Small population filter of the bicycle_with_accelerometer. Generated from its model by similitude; do not edit.
 *
 *   model: bicycle_with_accelerometer, Brennan & Alleyne 2004, eqs 1-4
 *   base: m, L, U
 *   unknowns: K, pi1, eta, rho, lead
 *   coordinates: v_star, r_star, disturbance, K, pi1, eta, rho, lead, output_bias, ay_bias
 *
 * Operations: step 1272 at most, 5 at least (arithmetic, comparisons, selects), init 8.
 * Memory: state 97 reals, configuration 80 reals; no heap, no globals, no libm, C99.
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

typedef SIMILITUDE_REAL bicycle_with_accelerometer_small_population_real;
#define R(x) ((bicycle_with_accelerometer_small_population_real)(x))

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

enum bicycle_with_accelerometer_small_population_status {
    BICYCLE_WITH_ACCELEROMETER_SMALL_POPULATION_OK = 0,
    BICYCLE_WITH_ACCELEROMETER_SMALL_POPULATION_NOT_EXCITED = 1,
    BICYCLE_WITH_ACCELEROMETER_SMALL_POPULATION_OUTSIDE_LINEAR = 2,
    BICYCLE_WITH_ACCELEROMETER_SMALL_POPULATION_AT_LIMIT = 3,
    BICYCLE_WITH_ACCELEROMETER_SMALL_POPULATION_NO_MEASUREMENT = 4,
    BICYCLE_WITH_ACCELEROMETER_SMALL_POPULATION_RESTARTED = 5,
    BICYCLE_WITH_ACCELEROMETER_SMALL_POPULATION_TOO_SLOW = 6,
    BICYCLE_WITH_ACCELEROMETER_SMALL_POPULATION_BAD_SAMPLE = 7
};

typedef struct bicycle_with_accelerometer_small_population_config {
    bicycle_with_accelerometer_small_population_real L; /* [m] wheelbase */
    bicycle_with_accelerometer_small_population_real K_prior; /* [m^2/s^2] prior of Caf L/m, front cornering stiffness per mass and length */
    bicycle_with_accelerometer_small_population_real pi1_prior; /* [-] prior of a/L, position of the centre of gravity */
    bicycle_with_accelerometer_small_population_real eta_prior; /* [-] prior of rear over front cornering coefficient; > 1 understeers */
    bicycle_with_accelerometer_small_population_real rho_prior; /* [-] prior of Iz/(m a b), yaw inertia ratio */
    bicycle_with_accelerometer_small_population_real lead_prior; /* [-] prior of accelerometer ahead of the centre of gravity over L */
    bicycle_with_accelerometer_small_population_real P_prior[15]; /* [-] prior covariance of the unknowns' coordinates, upper triangle */
    bicycle_with_accelerometer_small_population_real prior_information; /* [-] 1/prior variance of ln K */
    bicycle_with_accelerometer_small_population_real K_low; /* [m^2/s^2] lowest value the population allows */
    bicycle_with_accelerometer_small_population_real K_high; /* [m^2/s^2] highest value the population allows */
    bicycle_with_accelerometer_small_population_real pi1_low; /* [-] lowest value the population allows */
    bicycle_with_accelerometer_small_population_real pi1_high; /* [-] highest value the population allows */
    bicycle_with_accelerometer_small_population_real eta_low; /* [-] lowest value the population allows */
    bicycle_with_accelerometer_small_population_real eta_high; /* [-] highest value the population allows */
    bicycle_with_accelerometer_small_population_real rho_low; /* [-] lowest value the population allows */
    bicycle_with_accelerometer_small_population_real rho_high; /* [-] highest value the population allows */
    bicycle_with_accelerometer_small_population_real lead_low; /* [-] lowest value the population allows */
    bicycle_with_accelerometer_small_population_real lead_high; /* [-] highest value the population allows */
    bicycle_with_accelerometer_small_population_real output_bias_sd; /* [rad/s] prior sd of the bias of r */
    bicycle_with_accelerometer_small_population_real v_star_sd; /* [-] sd after a restart */
    bicycle_with_accelerometer_small_population_real r_star_sd; /* [-] sd after a restart */
    bicycle_with_accelerometer_small_population_real noise_variance; /* [(rad/s)^2] white noise of r a sample */
    bicycle_with_accelerometer_small_population_real drift; /* [1/s] diffusion of ln K while it is observed */
    bicycle_with_accelerometer_small_population_real idle_drift; /* [1/s] diffusion of ln K while nothing is heard of it */
    bicycle_with_accelerometer_small_population_real jump_drift; /* [1/s] further diffusion per unit of surprise above its limit */
    bicycle_with_accelerometer_small_population_real bias_drift; /* [(rad/s)^2/s] random walk of the output bias */
    bicycle_with_accelerometer_small_population_real timing_error; /* [s] timing error between input and output */
    bicycle_with_accelerometer_small_population_real structure_share; /* [-] structural error as a share of the output's activity */
    bicycle_with_accelerometer_small_population_real structure_time; /* [s] correlation time of the structural error */
    bicycle_with_accelerometer_small_population_real activity_rate; /* [1/s] averaging rate of the output's activity */
    bicycle_with_accelerometer_small_population_real disturbance_floor; /* [rad] disturbance at rest, equivalent input */
    bicycle_with_accelerometer_small_population_real disturbance_share; /* [-] disturbance as a share of the dimensionless activity */
    bicycle_with_accelerometer_small_population_real disturbance_rate; /* [1/s] 1/correlation time of the disturbance */
    bicycle_with_accelerometer_small_population_real disturbance_adapt; /* [1/s] adaptation rate of the disturbance's size */
    bicycle_with_accelerometer_small_population_real disturbance_scale_start; /* [-] disturbance variance against nominal at the start */
    bicycle_with_accelerometer_small_population_real disturbance_scale_low; /* [-] least disturbance variance against nominal */
    bicycle_with_accelerometer_small_population_real disturbance_scale_high; /* [-] greatest disturbance variance against nominal */
    bicycle_with_accelerometer_small_population_real noise_adapt; /* [1/s] adaptation rate of the noise's size in the long run */
    bicycle_with_accelerometer_small_population_real noise_scale_low; /* [-] least noise variance against nominal */
    bicycle_with_accelerometer_small_population_real noise_scale_high; /* [-] greatest noise variance against nominal */
    bicycle_with_accelerometer_small_population_real excitation_ratio; /* [-] least variance of sensitivity against noise to learn from */
    bicycle_with_accelerometer_small_population_real excitation_rate; /* [1/s] averaging rate of the excitation */
    bicycle_with_accelerometer_small_population_real seldom; /* [s] least time between samples that the seldom learnt unknowns learn from */
    bicycle_with_accelerometer_small_population_real surprise_rate; /* [1/s] averaging rate of the normalised innovation */
    bicycle_with_accelerometer_small_population_real jump_ratio; /* [-] squared surprise against its long-run mean that speaks of a jump */
    bicycle_with_accelerometer_small_population_real surprise_limit; /* [-] mean squared normalised innovation that speaks of a jump */
    bicycle_with_accelerometer_small_population_real heard_rate; /* [1/s] rate at which what was told of the first unknown is forgotten */
    bicycle_with_accelerometer_small_population_real faint_drift; /* [1/s] further diffusion of ln K while a jump could not show */
    bicycle_with_accelerometer_small_population_real inv_telling; /* [-] 1/information of late in which a jump shows */
    bicycle_with_accelerometer_small_population_real observed_least; /* [-] least share of the disturbance taken as observed */
    bicycle_with_accelerometer_small_population_real outlier_ratio; /* [-] squared innovation over its variance beyond which it is bounded */
    bicycle_with_accelerometer_small_population_real longest; /* [s] longest time a sample counts for in an average */
    bicycle_with_accelerometer_small_population_real gap; /* [s] longest time without a usable sample before a restart */
    bicycle_with_accelerometer_small_population_real input_limit; /* [rad] greatest believable delta */
    bicycle_with_accelerometer_small_population_real output_limit; /* [rad/s] greatest believable r */
    bicycle_with_accelerometer_small_population_real signal_limit; /* [m/s] greatest believable scale */
    bicycle_with_accelerometer_small_population_real validity_limit; /* [m/s^2] edge of the model's linear range */
    bicycle_with_accelerometer_small_population_real validity_rate; /* [1/s] decay rate of the memory of a visit outside the linear range */
    bicycle_with_accelerometer_small_population_real ay_bias_sd; /* [m/s^2] prior sd of the bias of ay */
    bicycle_with_accelerometer_small_population_real ay_bias_drift; /* [(m/s^2)^2/s] random walk of the bias of ay */
    bicycle_with_accelerometer_small_population_real ay_variance; /* [(m/s^2)^2] white noise of ay a sample */
    bicycle_with_accelerometer_small_population_real ay_share; /* [-] structural error of ay as a share of it */
    bicycle_with_accelerometer_small_population_real ay_time; /* [s] correlation time of what ay holds besides the model */
    bicycle_with_accelerometer_small_population_real ay_noise_scale_low; /* [-] least noise variance of ay against nominal */
    bicycle_with_accelerometer_small_population_real ay_noise_scale_high; /* [-] greatest noise variance of ay against nominal */
    bicycle_with_accelerometer_small_population_real ay_limit; /* [m/s^2] greatest believable ay */
} bicycle_with_accelerometer_small_population_config;

typedef struct bicycle_with_accelerometer_small_population_state {
    bicycle_with_accelerometer_small_population_real v_star; /* [-] dimensionless state */
    bicycle_with_accelerometer_small_population_real r_star; /* [-] dimensionless state */
    bicycle_with_accelerometer_small_population_real disturbance; /* [rad] disturbance as an equivalent delta */
    bicycle_with_accelerometer_small_population_real K; /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_with_accelerometer_small_population_real pi1; /* [-] a/L, position of the centre of gravity */
    bicycle_with_accelerometer_small_population_real eta; /* [-] rear over front cornering coefficient; > 1 understeers */
    bicycle_with_accelerometer_small_population_real rho; /* [-] Iz/(m a b), yaw inertia ratio */
    bicycle_with_accelerometer_small_population_real lead; /* [-] accelerometer ahead of the centre of gravity over L */
    bicycle_with_accelerometer_small_population_real output_bias; /* [rad/s] bias of r */
    bicycle_with_accelerometer_small_population_real ay_with[10]; /* [m/s^2] covariance of ay with the coordinates */
    bicycle_with_accelerometer_small_population_real ay_spread; /* [(m/s^2)^2] variance of ay predicted */
    bicycle_with_accelerometer_small_population_real last_ay; /* [m/s^2] ay of the sample before */
    bicycle_with_accelerometer_small_population_real ay_bias; /* [m/s^2] bias of ay */
    bicycle_with_accelerometer_small_population_real ay_activity; /* [(m/s^2)^2] mean square of ay predicted */
    bicycle_with_accelerometer_small_population_real ay_noise_scale; /* [-] noise variance of ay against nominal */
    bicycle_with_accelerometer_small_population_real P[55]; /* [-] covariance of the coordinates above, upper triangle by rows */
    bicycle_with_accelerometer_small_population_real noise_scale; /* [-] noise variance against nominal */
    bicycle_with_accelerometer_small_population_real disturbance_scale; /* [-] disturbance variance against nominal */
    bicycle_with_accelerometer_small_population_real activity; /* [(rad/s)^2] mean square of the predicted output */
    bicycle_with_accelerometer_small_population_real settling; /* [1/s] adaptation rate of the noise's size now, fast at first */
    bicycle_with_accelerometer_small_population_real restlessness; /* [-] long-run mean square of the surprise beyond one */
    bicycle_with_accelerometer_small_population_real jump; /* [-] surprise taken as a jump of the first unknown */
    bicycle_with_accelerometer_small_population_real surprise; /* [-] recent mean of the normalised innovation squared */
    bicycle_with_accelerometer_small_population_real heard; /* [-] recent information about the first unknown */
    bicycle_with_accelerometer_small_population_real excitation; /* [(rad/s)^2] mean square sensitivity to the first unknown */
    bicycle_with_accelerometer_small_population_real excited; /* [-] 1 while the input excites the first unknown, else 0 */
    bicycle_with_accelerometer_small_population_real unlearnt; /* [s] time since the seldom learnt unknowns last learnt anything */
    bicycle_with_accelerometer_small_population_real validity; /* [(m/s^2)^2] recent peak of the validity signal, squared */
    bicycle_with_accelerometer_small_population_real information; /* [-] information gained about ln K */
    bicycle_with_accelerometer_small_population_real last_input; /* [rad] input of the sample before */
    bicycle_with_accelerometer_small_population_real last_U; /* [m/s] forward speed of the sample before */
    bicycle_with_accelerometer_small_population_real age; /* [s] time since the last usable sample */
    bicycle_with_accelerometer_small_population_real turn; /* [-] which size adapts next: 0 disturbance, 1 noise, 2 excitation */
    bicycle_with_accelerometer_small_population_real started; /* [-] 1 once a sample was used; 0 again while the scales hide the dynamics */
} bicycle_with_accelerometer_small_population_state;

typedef struct bicycle_with_accelerometer_small_population_sample {
    bicycle_with_accelerometer_small_population_real dt; /* [s] time since the sample before */
    bicycle_with_accelerometer_small_population_real input; /* [rad] road-wheel steer angle */
    bicycle_with_accelerometer_small_population_real U; /* [m/s] forward speed */
    bicycle_with_accelerometer_small_population_real measured; /* [rad/s] measured yaw rate */
    bicycle_with_accelerometer_small_population_real ay_measured; /* [m/s^2] measured lateral acceleration */
} bicycle_with_accelerometer_small_population_sample;

typedef struct bicycle_with_accelerometer_small_population_output {
    bicycle_with_accelerometer_small_population_real estimate; /* [m^2/s^2] Caf L/m, front cornering stiffness per mass and length */
    bicycle_with_accelerometer_small_population_real variance; /* [-] variance of ln K */
    bicycle_with_accelerometer_small_population_real predicted; /* [rad/s] yaw rate predicted before the measurement */
    bicycle_with_accelerometer_small_population_real innovation; /* [rad/s] measured minus predicted; 0 without a measurement */
    bicycle_with_accelerometer_small_population_real innovation_variance; /* [(rad/s)^2] variance of the innovation */
    bicycle_with_accelerometer_small_population_real information_gained; /* [-] information gained about ln K so far */
} bicycle_with_accelerometer_small_population_output;

/* The state before the first sample: the prior. */
SIMILITUDE_API void bicycle_with_accelerometer_small_population_init(const bicycle_with_accelerometer_small_population_config *config, bicycle_with_accelerometer_small_population_state *state)
{
    bicycle_with_accelerometer_small_population_real *const ay_with = state->ay_with;
    bicycle_with_accelerometer_small_population_real *const P = state->P;
    int i;
    for (i = 0; i < 10; ++i) {
        ay_with[i] = R(0.0);
    }
    for (i = 0; i < 55; ++i) {
        P[i] = R(0.0);
    }
    state->v_star = R(0.0);
    state->r_star = R(0.0);
    state->disturbance = R(0.0);
    state->K = config->K_prior;
    state->pi1 = config->pi1_prior;
    state->eta = config->eta_prior;
    state->rho = config->rho_prior;
    state->lead = config->lead_prior;
    state->output_bias = R(0.0);
    P[0] = (config->v_star_sd*config->v_star_sd);
    P[10] = (config->r_star_sd*config->r_star_sd);
    P[52] = (config->output_bias_sd*config->output_bias_sd);
    P[54] = (config->ay_bias_sd*config->ay_bias_sd);
    P[27] = config->P_prior[0];
    P[28] = config->P_prior[1];
    P[29] = config->P_prior[2];
    P[30] = config->P_prior[3];
    P[31] = config->P_prior[4];
    P[34] = config->P_prior[5];
    P[35] = config->P_prior[6];
    P[36] = config->P_prior[7];
    P[37] = config->P_prior[8];
    P[40] = config->P_prior[9];
    P[41] = config->P_prior[10];
    P[42] = config->P_prior[11];
    P[45] = config->P_prior[12];
    P[46] = config->P_prior[13];
    P[49] = config->P_prior[14];
    state->noise_scale = R(1.0);
    state->surprise = R(1.0);
    state->settling = R(1.0);
    state->disturbance_scale = config->disturbance_scale_start;
    state->last_U = R(0.0003333333333333333)*config->signal_limit;
    state->last_ay = R(2.0)*config->ay_limit;
    state->ay_noise_scale = R(1.0);
    P[19] = state->disturbance_scale*(config->disturbance_floor*config->disturbance_floor);
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
    state->turn = R(0.0);
    state->ay_bias = R(0.0);
    state->ay_activity = R(0.0);
    state->ay_spread = R(0.0);
}

/* A part of the step: propagate. */
SIMILITUDE_PART void bicycle_with_accelerometer_small_population_propagate(
        const bicycle_with_accelerometer_small_population_config *config,
        bicycle_with_accelerometer_small_population_state *state,
        const bicycle_with_accelerometer_small_population_real held,
        const bicycle_with_accelerometer_small_population_real F_v_star_K,
        const bicycle_with_accelerometer_small_population_real F_v_star_eta,
        const bicycle_with_accelerometer_small_population_real F_v_star_lead,
        const bicycle_with_accelerometer_small_population_real F_v_star_pi1,
        const bicycle_with_accelerometer_small_population_real F_v_star_r_star,
        const bicycle_with_accelerometer_small_population_real F_v_star_rho,
        const bicycle_with_accelerometer_small_population_real F_v_star_u,
        const bicycle_with_accelerometer_small_population_real F_v_star_v_star,
        const bicycle_with_accelerometer_small_population_real F_r_star_K,
        const bicycle_with_accelerometer_small_population_real F_r_star_eta,
        const bicycle_with_accelerometer_small_population_real F_r_star_lead,
        const bicycle_with_accelerometer_small_population_real F_r_star_pi1,
        const bicycle_with_accelerometer_small_population_real F_r_star_r_star,
        const bicycle_with_accelerometer_small_population_real F_r_star_rho,
        const bicycle_with_accelerometer_small_population_real F_r_star_u,
        const bicycle_with_accelerometer_small_population_real F_r_star_v_star,
        const bicycle_with_accelerometer_small_population_real ay_by_7,
        const bicycle_with_accelerometer_small_population_real ay_from_0,
        const bicycle_with_accelerometer_small_population_real ay_from_1,
        const bicycle_with_accelerometer_small_population_real ay_to_0,
        const bicycle_with_accelerometer_small_population_real ay_to_1,
        const bicycle_with_accelerometer_small_population_real w_nominal)
{
    bicycle_with_accelerometer_small_population_real *const ay_with = state->ay_with;
    bicycle_with_accelerometer_small_population_real *const P = state->P;
    const bicycle_with_accelerometer_small_population_real keep_w = R(1.0) - config->disturbance_rate*held;
    const bicycle_with_accelerometer_small_population_real PW_0 = P[2];
    const bicycle_with_accelerometer_small_population_real FP_0_0 = F_v_star_K*P[3] + F_v_star_eta*P[5] + F_v_star_lead*P[7] + F_v_star_pi1*P[4] + F_v_star_r_star*P[1] + F_v_star_rho*P[6] + F_v_star_u*PW_0 + F_v_star_v_star*P[0];
    const bicycle_with_accelerometer_small_population_real FP_1_0 = F_r_star_K*P[3] + F_r_star_eta*P[5] + F_r_star_lead*P[7] + F_r_star_pi1*P[4] + F_r_star_r_star*P[1] + F_r_star_rho*P[6] + F_r_star_u*PW_0 + F_r_star_v_star*P[0];
    const bicycle_with_accelerometer_small_population_real PW_1 = P[11];
    const bicycle_with_accelerometer_small_population_real FP_0_1 = F_v_star_K*P[12] + F_v_star_eta*P[14] + F_v_star_lead*P[16] + F_v_star_pi1*P[13] + F_v_star_r_star*P[10] + F_v_star_rho*P[15] + F_v_star_u*PW_1 + F_v_star_v_star*P[1];
    const bicycle_with_accelerometer_small_population_real FP_1_1 = F_r_star_K*P[12] + F_r_star_eta*P[14] + F_r_star_lead*P[16] + F_r_star_pi1*P[13] + F_r_star_r_star*P[10] + F_r_star_rho*P[15] + F_r_star_u*PW_1 + F_r_star_v_star*P[1];
    const bicycle_with_accelerometer_small_population_real ay_before_0 = P[9] + FP_0_0*ay_to_0 + FP_1_0*ay_to_1 + P[0]*ay_from_0 + P[1]*ay_from_1 + P[7]*ay_by_7;
    const bicycle_with_accelerometer_small_population_real ay_before_1 = P[18] + FP_0_1*ay_to_0 + FP_1_1*ay_to_1 + P[1]*ay_from_0 + P[10]*ay_from_1 + P[16]*ay_by_7;
    P[0] = FP_0_0*F_v_star_v_star + FP_0_1*F_v_star_r_star;
    P[1] = FP_0_0*F_r_star_v_star + FP_0_1*F_r_star_r_star;
    P[10] = FP_1_0*F_r_star_v_star + FP_1_1*F_r_star_r_star;
    const bicycle_with_accelerometer_small_population_real PW_2 = P[19];
    const bicycle_with_accelerometer_small_population_real FP_0_2 = F_v_star_K*P[20] + F_v_star_eta*P[22] + F_v_star_lead*P[24] + F_v_star_pi1*P[21] + F_v_star_r_star*P[11] + F_v_star_rho*P[23] + F_v_star_u*PW_2 + F_v_star_v_star*P[2];
    const bicycle_with_accelerometer_small_population_real FP_1_2 = F_r_star_K*P[20] + F_r_star_eta*P[22] + F_r_star_lead*P[24] + F_r_star_pi1*P[21] + F_r_star_r_star*P[11] + F_r_star_rho*P[23] + F_r_star_u*PW_2 + F_r_star_v_star*P[2];
    ay_with[2] = keep_w*(P[26] + FP_0_2*ay_to_0 + FP_1_2*ay_to_1 + P[11]*ay_from_1 + P[2]*ay_from_0 + P[24]*ay_by_7);
    P[2] = FP_0_2*keep_w;
    P[11] = FP_1_2*keep_w;
    const bicycle_with_accelerometer_small_population_real PW_3 = P[20];
    const bicycle_with_accelerometer_small_population_real FP_0_3 = F_v_star_K*P[27] + F_v_star_eta*P[29] + F_v_star_lead*P[31] + F_v_star_pi1*P[28] + F_v_star_r_star*P[12] + F_v_star_rho*P[30] + F_v_star_u*PW_3 + F_v_star_v_star*P[3];
    const bicycle_with_accelerometer_small_population_real FP_1_3 = F_r_star_K*P[27] + F_r_star_eta*P[29] + F_r_star_lead*P[31] + F_r_star_pi1*P[28] + F_r_star_r_star*P[12] + F_r_star_rho*P[30] + F_r_star_u*PW_3 + F_r_star_v_star*P[3];
    ay_with[3] = P[33] + FP_0_3*ay_to_0 + FP_1_3*ay_to_1 + P[12]*ay_from_1 + P[3]*ay_from_0 + P[31]*ay_by_7;
    P[3] = FP_0_3;
    P[12] = FP_1_3;
    P[0] = P[0] + FP_0_3*F_v_star_K;
    P[1] = P[1] + FP_0_3*F_r_star_K;
    P[10] = P[10] + FP_1_3*F_r_star_K;
    const bicycle_with_accelerometer_small_population_real PW_4 = P[21];
    const bicycle_with_accelerometer_small_population_real FP_0_4 = F_v_star_K*P[28] + F_v_star_eta*P[35] + F_v_star_lead*P[37] + F_v_star_pi1*P[34] + F_v_star_r_star*P[13] + F_v_star_rho*P[36] + F_v_star_u*PW_4 + F_v_star_v_star*P[4];
    const bicycle_with_accelerometer_small_population_real FP_1_4 = F_r_star_K*P[28] + F_r_star_eta*P[35] + F_r_star_lead*P[37] + F_r_star_pi1*P[34] + F_r_star_r_star*P[13] + F_r_star_rho*P[36] + F_r_star_u*PW_4 + F_r_star_v_star*P[4];
    ay_with[4] = P[39] + FP_0_4*ay_to_0 + FP_1_4*ay_to_1 + P[13]*ay_from_1 + P[37]*ay_by_7 + P[4]*ay_from_0;
    P[4] = FP_0_4;
    P[13] = FP_1_4;
    P[0] = P[0] + FP_0_4*F_v_star_pi1;
    P[1] = P[1] + FP_0_4*F_r_star_pi1;
    P[10] = P[10] + FP_1_4*F_r_star_pi1;
    const bicycle_with_accelerometer_small_population_real PW_5 = P[22];
    const bicycle_with_accelerometer_small_population_real FP_0_5 = F_v_star_K*P[29] + F_v_star_eta*P[40] + F_v_star_lead*P[42] + F_v_star_pi1*P[35] + F_v_star_r_star*P[14] + F_v_star_rho*P[41] + F_v_star_u*PW_5 + F_v_star_v_star*P[5];
    const bicycle_with_accelerometer_small_population_real FP_1_5 = F_r_star_K*P[29] + F_r_star_eta*P[40] + F_r_star_lead*P[42] + F_r_star_pi1*P[35] + F_r_star_r_star*P[14] + F_r_star_rho*P[41] + F_r_star_u*PW_5 + F_r_star_v_star*P[5];
    ay_with[5] = P[44] + FP_0_5*ay_to_0 + FP_1_5*ay_to_1 + P[14]*ay_from_1 + P[42]*ay_by_7 + P[5]*ay_from_0;
    P[5] = FP_0_5;
    P[14] = FP_1_5;
    P[0] = P[0] + FP_0_5*F_v_star_eta;
    P[1] = P[1] + FP_0_5*F_r_star_eta;
    P[10] = P[10] + FP_1_5*F_r_star_eta;
    const bicycle_with_accelerometer_small_population_real PW_6 = P[23];
    const bicycle_with_accelerometer_small_population_real FP_0_6 = F_v_star_K*P[30] + F_v_star_eta*P[41] + F_v_star_lead*P[46] + F_v_star_pi1*P[36] + F_v_star_r_star*P[15] + F_v_star_rho*P[45] + F_v_star_u*PW_6 + F_v_star_v_star*P[6];
    const bicycle_with_accelerometer_small_population_real FP_1_6 = F_r_star_K*P[30] + F_r_star_eta*P[41] + F_r_star_lead*P[46] + F_r_star_pi1*P[36] + F_r_star_r_star*P[15] + F_r_star_rho*P[45] + F_r_star_u*PW_6 + F_r_star_v_star*P[6];
    ay_with[6] = P[48] + FP_0_6*ay_to_0 + FP_1_6*ay_to_1 + P[15]*ay_from_1 + P[46]*ay_by_7 + P[6]*ay_from_0;
    P[6] = FP_0_6;
    P[15] = FP_1_6;
    P[0] = P[0] + FP_0_6*F_v_star_rho;
    P[1] = P[1] + FP_0_6*F_r_star_rho;
    P[10] = P[10] + FP_1_6*F_r_star_rho;
    const bicycle_with_accelerometer_small_population_real PW_7 = P[24];
    const bicycle_with_accelerometer_small_population_real FP_0_7 = F_v_star_K*P[31] + F_v_star_eta*P[42] + F_v_star_lead*P[49] + F_v_star_pi1*P[37] + F_v_star_r_star*P[16] + F_v_star_rho*P[46] + F_v_star_u*PW_7 + F_v_star_v_star*P[7];
    const bicycle_with_accelerometer_small_population_real FP_1_7 = F_r_star_K*P[31] + F_r_star_eta*P[42] + F_r_star_lead*P[49] + F_r_star_pi1*P[37] + F_r_star_r_star*P[16] + F_r_star_rho*P[46] + F_r_star_u*PW_7 + F_r_star_v_star*P[7];
    ay_with[7] = P[51] + FP_0_7*ay_to_0 + FP_1_7*ay_to_1 + P[16]*ay_from_1 + P[49]*ay_by_7 + P[7]*ay_from_0;
    P[7] = FP_0_7;
    P[16] = FP_1_7;
    P[0] = P[0] + FP_0_7*F_v_star_lead;
    P[1] = P[1] + FP_0_7*F_r_star_lead;
    P[10] = P[10] + FP_1_7*F_r_star_lead;
    const bicycle_with_accelerometer_small_population_real PW_8 = P[25];
    const bicycle_with_accelerometer_small_population_real FP_0_8 = F_v_star_K*P[32] + F_v_star_eta*P[43] + F_v_star_lead*P[50] + F_v_star_pi1*P[38] + F_v_star_r_star*P[17] + F_v_star_rho*P[47] + F_v_star_u*PW_8 + F_v_star_v_star*P[8];
    const bicycle_with_accelerometer_small_population_real FP_1_8 = F_r_star_K*P[32] + F_r_star_eta*P[43] + F_r_star_lead*P[50] + F_r_star_pi1*P[38] + F_r_star_r_star*P[17] + F_r_star_rho*P[47] + F_r_star_u*PW_8 + F_r_star_v_star*P[8];
    ay_with[8] = P[53] + FP_0_8*ay_to_0 + FP_1_8*ay_to_1 + P[17]*ay_from_1 + P[50]*ay_by_7 + P[8]*ay_from_0;
    P[8] = FP_0_8;
    P[17] = FP_1_8;
    const bicycle_with_accelerometer_small_population_real PW_9 = P[26];
    const bicycle_with_accelerometer_small_population_real FP_0_9 = F_v_star_K*P[33] + F_v_star_eta*P[44] + F_v_star_lead*P[51] + F_v_star_pi1*P[39] + F_v_star_r_star*P[18] + F_v_star_rho*P[48] + F_v_star_u*PW_9 + F_v_star_v_star*P[9];
    const bicycle_with_accelerometer_small_population_real FP_1_9 = F_r_star_K*P[33] + F_r_star_eta*P[44] + F_r_star_lead*P[51] + F_r_star_pi1*P[39] + F_r_star_r_star*P[18] + F_r_star_rho*P[48] + F_r_star_u*PW_9 + F_r_star_v_star*P[9];
    ay_with[9] = P[54] + FP_0_9*ay_to_0 + FP_1_9*ay_to_1 + P[18]*ay_from_1 + P[51]*ay_by_7 + P[9]*ay_from_0;
    P[9] = FP_0_9;
    P[18] = FP_1_9;
    const bicycle_with_accelerometer_small_population_real WPF_0 = FP_0_2;
    const bicycle_with_accelerometer_small_population_real WPF_1 = FP_1_2;
    P[0] = P[0] + F_v_star_u*WPF_0;
    P[1] = P[1] + F_r_star_u*WPF_0;
    P[10] = P[10] + F_r_star_u*WPF_1;
    P[19] = P[19]*(keep_w*keep_w) + state->disturbance_scale*w_nominal*(R(1.0) - (keep_w*keep_w));
    P[20] = P[20]*keep_w;
    P[21] = P[21]*keep_w;
    P[22] = P[22]*keep_w;
    P[23] = P[23]*keep_w;
    P[24] = P[24]*keep_w;
    P[25] = P[25]*keep_w;
    P[26] = P[26]*keep_w;
    ay_with[0] = P[9] + FP_0_0*ay_from_0 + FP_0_1*ay_from_1 + P[0]*ay_to_0 + P[1]*ay_to_1 + P[7]*ay_by_7;
    ay_with[1] = P[18] + FP_1_0*ay_from_0 + FP_1_1*ay_from_1 + P[1]*ay_to_0 + P[10]*ay_to_1 + P[16]*ay_by_7;
    state->ay_spread = ay_with[9] + ay_before_0*ay_from_0 + ay_before_1*ay_from_1 + ay_by_7*ay_with[7] + ay_to_0*ay_with[0] + ay_to_1*ay_with[1];
    state->disturbance = state->disturbance*keep_w;
}

/* A part of the step: correct. */
SIMILITUDE_PART void bicycle_with_accelerometer_small_population_correct(
        bicycle_with_accelerometer_small_population_state *state,
        const bicycle_with_accelerometer_small_population_real output_scale,
        const bicycle_with_accelerometer_small_population_real ay_after,
        const bicycle_with_accelerometer_small_population_real c_1,
        const bicycle_with_accelerometer_small_population_real c_8,
        const bicycle_with_accelerometer_small_population_real inv_spread,
        const bicycle_with_accelerometer_small_population_real ay_inv_spread,
        const bicycle_with_accelerometer_small_population_real ay_c_3,
        const bicycle_with_accelerometer_small_population_real c_3,
        const bicycle_with_accelerometer_small_population_real ay_innovation,
        const bicycle_with_accelerometer_small_population_real innovation)
{
    bicycle_with_accelerometer_small_population_real *const ay_with = state->ay_with;
    bicycle_with_accelerometer_small_population_real *const P = state->P;
    const bicycle_with_accelerometer_small_population_real c_0 = P[8] + P[1]*output_scale;
    const bicycle_with_accelerometer_small_population_real c_2 = P[25] + P[11]*output_scale;
    const bicycle_with_accelerometer_small_population_real c_4 = P[38] + P[13]*output_scale;
    const bicycle_with_accelerometer_small_population_real c_5 = P[43] + P[14]*output_scale;
    const bicycle_with_accelerometer_small_population_real c_6 = P[47] + P[15]*output_scale;
    const bicycle_with_accelerometer_small_population_real c_7 = P[50] + P[16]*output_scale;
    const bicycle_with_accelerometer_small_population_real c_9 = P[53] + P[18]*output_scale;
    const bicycle_with_accelerometer_small_population_real ay_c_0 = ay_with[0] - ay_after*c_0;
    const bicycle_with_accelerometer_small_population_real ay_c_1 = ay_with[1] - ay_after*c_1;
    const bicycle_with_accelerometer_small_population_real ay_c_2 = ay_with[2] - ay_after*c_2;
    const bicycle_with_accelerometer_small_population_real ay_c_4 = ay_with[4] - ay_after*c_4;
    const bicycle_with_accelerometer_small_population_real ay_c_5 = ay_with[5] - ay_after*c_5;
    const bicycle_with_accelerometer_small_population_real ay_c_6 = ay_with[6] - ay_after*c_6;
    const bicycle_with_accelerometer_small_population_real ay_c_7 = ay_with[7] - ay_after*c_7;
    const bicycle_with_accelerometer_small_population_real ay_c_8 = ay_with[8] - ay_after*c_8;
    const bicycle_with_accelerometer_small_population_real ay_c_9 = ay_with[9] - ay_after*c_9;
    const bicycle_with_accelerometer_small_population_real gain_0 = c_0*inv_spread;
    const bicycle_with_accelerometer_small_population_real ay_gain_0 = ay_c_0*ay_inv_spread;
    P[0] = P[0] - ay_c_0*ay_gain_0 - c_0*gain_0;
    P[1] = P[1] - ay_c_1*ay_gain_0 - c_1*gain_0;
    P[2] = P[2] - ay_c_2*ay_gain_0 - c_2*gain_0;
    P[3] = P[3] - ay_c_3*ay_gain_0 - c_3*gain_0;
    P[4] = P[4] - ay_c_4*ay_gain_0 - c_4*gain_0;
    P[5] = P[5] - ay_c_5*ay_gain_0 - c_5*gain_0;
    P[6] = P[6] - ay_c_6*ay_gain_0 - c_6*gain_0;
    P[7] = P[7] - ay_c_7*ay_gain_0 - c_7*gain_0;
    P[8] = P[8] - ay_c_8*ay_gain_0 - c_8*gain_0;
    P[9] = P[9] - ay_c_9*ay_gain_0 - c_9*gain_0;
    state->v_star = state->v_star + ay_gain_0*ay_innovation + gain_0*innovation;
    const bicycle_with_accelerometer_small_population_real gain_1 = c_1*inv_spread;
    const bicycle_with_accelerometer_small_population_real ay_gain_1 = ay_c_1*ay_inv_spread;
    P[10] = P[10] - ay_c_1*ay_gain_1 - c_1*gain_1;
    P[11] = P[11] - ay_c_2*ay_gain_1 - c_2*gain_1;
    P[12] = P[12] - ay_c_3*ay_gain_1 - c_3*gain_1;
    P[13] = P[13] - ay_c_4*ay_gain_1 - c_4*gain_1;
    P[14] = P[14] - ay_c_5*ay_gain_1 - c_5*gain_1;
    P[15] = P[15] - ay_c_6*ay_gain_1 - c_6*gain_1;
    P[16] = P[16] - ay_c_7*ay_gain_1 - c_7*gain_1;
    P[17] = P[17] - ay_c_8*ay_gain_1 - c_8*gain_1;
    P[18] = P[18] - ay_c_9*ay_gain_1 - c_9*gain_1;
    state->r_star = state->r_star + ay_gain_1*ay_innovation + gain_1*innovation;
    const bicycle_with_accelerometer_small_population_real gain_2 = c_2*inv_spread;
    const bicycle_with_accelerometer_small_population_real ay_gain_2 = ay_c_2*ay_inv_spread;
    P[19] = P[19] - ay_c_2*ay_gain_2 - c_2*gain_2;
    P[20] = P[20] - ay_c_3*ay_gain_2 - c_3*gain_2;
    P[21] = P[21] - ay_c_4*ay_gain_2 - c_4*gain_2;
    P[22] = P[22] - ay_c_5*ay_gain_2 - c_5*gain_2;
    P[23] = P[23] - ay_c_6*ay_gain_2 - c_6*gain_2;
    P[24] = P[24] - ay_c_7*ay_gain_2 - c_7*gain_2;
    P[25] = P[25] - ay_c_8*ay_gain_2 - c_8*gain_2;
    P[26] = P[26] - ay_c_9*ay_gain_2 - c_9*gain_2;
    state->disturbance = state->disturbance + ay_gain_2*ay_innovation + gain_2*innovation;
    const bicycle_with_accelerometer_small_population_real gain_8 = c_8*inv_spread;
    const bicycle_with_accelerometer_small_population_real ay_gain_8 = ay_c_8*ay_inv_spread;
    P[32] = P[32] - ay_c_3*ay_gain_8 - c_3*gain_8;
    P[38] = P[38] - ay_c_4*ay_gain_8 - c_4*gain_8;
    P[43] = P[43] - ay_c_5*ay_gain_8 - c_5*gain_8;
    P[47] = P[47] - ay_c_6*ay_gain_8 - c_6*gain_8;
    P[50] = P[50] - ay_c_7*ay_gain_8 - c_7*gain_8;
    P[52] = P[52] - ay_c_8*ay_gain_8 - c_8*gain_8;
    P[53] = P[53] - ay_c_9*ay_gain_8 - c_9*gain_8;
    state->output_bias = state->output_bias + ay_gain_8*ay_innovation + gain_8*innovation;
    const bicycle_with_accelerometer_small_population_real gain_9 = c_9*inv_spread;
    const bicycle_with_accelerometer_small_population_real ay_gain_9 = ay_c_9*ay_inv_spread;
    P[33] = P[33] - ay_c_3*ay_gain_9 - c_3*gain_9;
    P[39] = P[39] - ay_c_4*ay_gain_9 - c_4*gain_9;
    P[44] = P[44] - ay_c_5*ay_gain_9 - c_5*gain_9;
    P[48] = P[48] - ay_c_6*ay_gain_9 - c_6*gain_9;
    P[51] = P[51] - ay_c_7*ay_gain_9 - c_7*gain_9;
    P[54] = P[54] - ay_c_9*ay_gain_9 - c_9*gain_9;
    state->ay_bias = state->ay_bias + ay_gain_9*ay_innovation + gain_9*innovation;
}

/* A part of the step: learn. */
SIMILITUDE_PART void bicycle_with_accelerometer_small_population_learn(
        bicycle_with_accelerometer_small_population_state *state,
        const bicycle_with_accelerometer_small_population_real output_scale,
        const bicycle_with_accelerometer_small_population_real ay_after,
        const bicycle_with_accelerometer_small_population_real learn_seldom,
        const bicycle_with_accelerometer_small_population_real ay_learn_seldom,
        const bicycle_with_accelerometer_small_population_real learn_slow,
        const bicycle_with_accelerometer_small_population_real ay_learn_slow,
        const bicycle_with_accelerometer_small_population_real ay_c_3,
        const bicycle_with_accelerometer_small_population_real ay_gain_3,
        const bicycle_with_accelerometer_small_population_real c_3,
        const bicycle_with_accelerometer_small_population_real gain_3,
        const bicycle_with_accelerometer_small_population_real ay_innovation,
        const bicycle_with_accelerometer_small_population_real innovation)
{
    bicycle_with_accelerometer_small_population_real *const ay_with = state->ay_with;
    bicycle_with_accelerometer_small_population_real *const P = state->P;
    const bicycle_with_accelerometer_small_population_real c_4 = P[38] + P[13]*output_scale;
    const bicycle_with_accelerometer_small_population_real c_5 = P[43] + P[14]*output_scale;
    const bicycle_with_accelerometer_small_population_real c_6 = P[47] + P[15]*output_scale;
    const bicycle_with_accelerometer_small_population_real c_7 = P[50] + P[16]*output_scale;
    const bicycle_with_accelerometer_small_population_real ay_c_4 = ay_with[4] - ay_after*c_4;
    const bicycle_with_accelerometer_small_population_real ay_c_5 = ay_with[5] - ay_after*c_5;
    const bicycle_with_accelerometer_small_population_real ay_c_6 = ay_with[6] - ay_after*c_6;
    const bicycle_with_accelerometer_small_population_real ay_c_7 = ay_with[7] - ay_after*c_7;
    const bicycle_with_accelerometer_small_population_real gain_4 = c_4*learn_seldom;
    const bicycle_with_accelerometer_small_population_real ay_gain_4 = ay_c_4*ay_learn_seldom;
    const bicycle_with_accelerometer_small_population_real gain_5 = c_5*learn_slow;
    const bicycle_with_accelerometer_small_population_real ay_gain_5 = ay_c_5*ay_learn_slow;
    const bicycle_with_accelerometer_small_population_real gain_6 = c_6*learn_slow;
    const bicycle_with_accelerometer_small_population_real ay_gain_6 = ay_c_6*ay_learn_slow;
    P[27] = P[27] - ay_c_3*ay_gain_3 - c_3*gain_3;
    P[28] = P[28] - ay_c_4*ay_gain_3 - c_4*gain_3;
    P[29] = P[29] - ay_c_5*ay_gain_3 - c_5*gain_3;
    P[30] = P[30] - ay_c_6*ay_gain_3 - c_6*gain_3;
    P[31] = P[31] - ay_c_7*ay_gain_3 - c_7*gain_3;
    P[34] = P[34] - ay_c_4*ay_gain_4 - c_4*gain_4;
    P[35] = P[35] - ay_c_4*ay_gain_5 - c_4*gain_5;
    P[36] = P[36] - ay_c_4*ay_gain_6 - c_4*gain_6;
    P[37] = P[37] - ay_c_7*ay_gain_4 - c_7*gain_4;
    P[40] = P[40] - ay_c_5*ay_gain_5 - c_5*gain_5;
    P[41] = P[41] - ay_c_6*ay_gain_5 - c_6*gain_5;
    P[42] = P[42] - ay_c_7*ay_gain_5 - c_7*gain_5;
    P[45] = P[45] - ay_c_6*ay_gain_6 - c_6*gain_6;
    P[46] = P[46] - ay_c_7*ay_gain_6 - c_7*gain_6;
    state->pi1 = state->pi1 + ay_gain_4*ay_innovation + gain_4*innovation;
    const bicycle_with_accelerometer_small_population_real move_eta = ay_gain_5*ay_innovation + gain_5*innovation;
    const bicycle_with_accelerometer_small_population_real half_move_eta = R(1.0) + move_eta*(R(0.5) + R(0.125)*move_eta);
    state->eta = state->eta*(half_move_eta*half_move_eta);
    const bicycle_with_accelerometer_small_population_real move_rho = ay_gain_6*ay_innovation + gain_6*innovation;
    const bicycle_with_accelerometer_small_population_real half_move_rho = R(1.0) + move_rho*(R(0.5) + R(0.125)*move_rho);
    state->rho = state->rho*(half_move_rho*half_move_rho);
}

/* What the step and the batch loop do with one sample. */
SIMILITUDE_INLINE int bicycle_with_accelerometer_small_population_advance(const bicycle_with_accelerometer_small_population_config *config, bicycle_with_accelerometer_small_population_state *state,
                                     const bicycle_with_accelerometer_small_population_sample *sample, bicycle_with_accelerometer_small_population_output *output)
{
    bicycle_with_accelerometer_small_population_real *const ay_with = state->ay_with;
    bicycle_with_accelerometer_small_population_real *const P = state->P;
    bicycle_with_accelerometer_small_population_real U_now = R(0.0);
    int anew = 0;
    bicycle_with_accelerometer_small_population_real ay_after = R(0.0);
    bicycle_with_accelerometer_small_population_real ay_innovation = R(0.0);
    bicycle_with_accelerometer_small_population_real ay_inv_spread = R(0.0);
    bicycle_with_accelerometer_small_population_real ay_learn_seldom = R(0.0);
    bicycle_with_accelerometer_small_population_real ay_odd = R(0.0);
    bicycle_with_accelerometer_small_population_real d_r_star = R(0.0);
    bicycle_with_accelerometer_small_population_real d_v_star = R(0.0);
    bicycle_with_accelerometer_small_population_real diffusion = R(0.0);
    bicycle_with_accelerometer_small_population_real estimate = R(0.0);
    bicycle_with_accelerometer_small_population_real information_gained = R(0.0);
    bicycle_with_accelerometer_small_population_real innovation = R(0.0);
    bicycle_with_accelerometer_small_population_real innovation_variance = R(0.0);
    bicycle_with_accelerometer_small_population_real inv_spread = R(0.0);
    bicycle_with_accelerometer_small_population_real learn_seldom = R(0.0);
    bicycle_with_accelerometer_small_population_real linear = R(0.0);
    bicycle_with_accelerometer_small_population_real move = R(0.0);
    bicycle_with_accelerometer_small_population_real predicted = R(0.0);
    int status = 0;
    bicycle_with_accelerometer_small_population_real u_now = R(0.0);
    int usable = 0;
    bicycle_with_accelerometer_small_population_real variance = R(0.0);

    status = 0;
    predicted = state->output_bias;
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
        if (state->age > config->gap) { /* nothing was heard for long */
            anew = 1;
            if (usable > 0) {
                status = 5;
            }
        }
        if (!((R(10.0)*(U_now*U_now) > config->K_prior) && (U_now > R(0.0)))) { /* the dynamics cannot be seen */
            anew = 1;
            state->started = R(0.0);
            usable = 0;
            status = 6;
        }
        const bicycle_with_accelerometer_small_population_real least_scale = R(0.0003333333333333333)*config->signal_limit;
        const bicycle_with_accelerometer_small_population_real at_U = ((U_now) > (least_scale) ? U_now : least_scale); /* kept off zero */
        const bicycle_with_accelerometer_small_population_real inv_U = (R(1.0)/at_U);
        const bicycle_with_accelerometer_small_population_real inv_L = (R(1.0)/config->L);
        const bicycle_with_accelerometer_small_population_real held = ((sample->dt) < (config->longest) ? sample->dt : config->longest);
        const bicycle_with_accelerometer_small_population_real inv_dt = (R(1.0)/held);
        const bicycle_with_accelerometer_small_population_real output_scale = at_U*inv_L; /* r = scale x dimensionless */
        const bicycle_with_accelerometer_small_population_real inv_output_scale = config->L*inv_U;
        const bicycle_with_accelerometer_small_population_real h = at_U*sample->dt*inv_L; /* dimensionless time step */
        const bicycle_with_accelerometer_small_population_real w_nominal = (config->disturbance_floor*config->disturbance_floor) + state->activity*(config->disturbance_share*config->disturbance_share)*(inv_output_scale*inv_output_scale); /* nominal variance of the disturbance */
        if (anew > 0) { /* nothing is known of the dynamic state */
            state->excitation = R(0.0);
            state->excited = R(0.0);
            state->jump = R(0.0);
            state->heard = R(0.0);
            state->surprise = R(1.0);
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
            P[0] = (config->v_star_sd*config->v_star_sd);
            P[10] = (config->r_star_sd*config->r_star_sd);
            P[19] = state->disturbance_scale*(config->disturbance_floor*config->disturbance_floor);
            state->v_star = R(0.0);
            state->r_star = R(0.0);
            state->disturbance = R(0.0);
            d_v_star = R(0.0);
            d_r_star = R(0.0);
        } else {
            const bicycle_with_accelerometer_small_population_real ratio_v_star = inv_U*state->last_U; /* same physical state in the new scales */
            state->v_star = ratio_v_star*state->v_star;
            const bicycle_with_accelerometer_small_population_real ratio_r_star = inv_U*state->last_U; /* same physical state in the new scales */
            state->r_star = state->r_star*ratio_r_star;
            const bicycle_with_accelerometer_small_population_real steer = R(0.5)*state->last_input + R(0.5)*u_now; /* mean of the sample's two ends */
            const bicycle_with_accelerometer_small_population_real u = state->disturbance + steer; /* effective input [-] */
            const bicycle_with_accelerometer_small_population_real inv0 = (R(1.0)/state->rho);
            const bicycle_with_accelerometer_small_population_real inv1 = (R(1.0)/(state->pi1 - R(1.0)));
            const bicycle_with_accelerometer_small_population_real c0 = (-state->r_star);
            const bicycle_with_accelerometer_small_population_real c1 = state->pi1*state->r_star;
            const bicycle_with_accelerometer_small_population_real c2 = c1 + state->v_star;
            const bicycle_with_accelerometer_small_population_real c3 = c0 + c2;
            const bicycle_with_accelerometer_small_population_real c4 = c3*state->eta;
            const bicycle_with_accelerometer_small_population_real c5 = inv1*state->pi1;
            const bicycle_with_accelerometer_small_population_real c6 = c4*c5;
            const bicycle_with_accelerometer_small_population_real c7 = u - c1 - state->v_star;
            const bicycle_with_accelerometer_small_population_real c8 = state->K*(inv_U*inv_U);
            const bicycle_with_accelerometer_small_population_real c9 = c8*(c6 + c7);
            const bicycle_with_accelerometer_small_population_real c10 = c4 + c7;
            const bicycle_with_accelerometer_small_population_real c11 = c8*inv0;
            const bicycle_with_accelerometer_small_population_real c12 = c11*inv1;
            const bicycle_with_accelerometer_small_population_real c13 = (-c10*c12);
            const bicycle_with_accelerometer_small_population_real c14 = R(0.3333333333333333)*h;
            const bicycle_with_accelerometer_small_population_real c15 = state->eta - R(1.0);
            const bicycle_with_accelerometer_small_population_real c16 = c4*inv1;
            const bicycle_with_accelerometer_small_population_real f_v_star = c0 + c9; /* rate [-] */
            const bicycle_with_accelerometer_small_population_real f_r_star = c13; /* rate [-] */
            const bicycle_with_accelerometer_small_population_real J_00 = c14*c8*(c5*state->eta - R(1.0));
            const bicycle_with_accelerometer_small_population_real J_01 = c14*(c15*c8*state->pi1 - R(1.0));
            const bicycle_with_accelerometer_small_population_real J_10 = (-c12*c14*c15);
            const bicycle_with_accelerometer_small_population_real J_11 = c11*c14*(inv1*state->pi1 - state->eta);
            const bicycle_with_accelerometer_small_population_real f_v_star_K = c9;
            const bicycle_with_accelerometer_small_population_real f_r_star_K = c13;
            const bicycle_with_accelerometer_small_population_real f_v_star_pi1 = c8*(c3*state->eta*inv1 + state->eta*inv1*state->pi1*state->r_star - state->r_star - c4*state->pi1*(inv1*inv1));
            const bicycle_with_accelerometer_small_population_real f_r_star_pi1 = c12*(c16 + state->r_star - state->eta*state->r_star - inv1*(c2 - u));
            const bicycle_with_accelerometer_small_population_real f_v_star_eta = c6*c8;
            const bicycle_with_accelerometer_small_population_real f_r_star_eta = (-c11*c16);
            const bicycle_with_accelerometer_small_population_real f_v_star_rho = R(0.0);
            const bicycle_with_accelerometer_small_population_real f_r_star_rho = c10*c12;
            const bicycle_with_accelerometer_small_population_real f_v_star_lead = R(0.0);
            const bicycle_with_accelerometer_small_population_real f_r_star_lead = R(0.0);
            const bicycle_with_accelerometer_small_population_real f_v_star_u = c8;
            const bicycle_with_accelerometer_small_population_real f_r_star_u = (-c12);
            const bicycle_with_accelerometer_small_population_real p0 = J_00*J_11 - J_01*J_10;
            const bicycle_with_accelerometer_small_population_real p1 = (-J_00) - J_11;
            const bicycle_with_accelerometer_small_population_real n0 = R(1.0) - R(1.5)*p0;
            const bicycle_with_accelerometer_small_population_real n1 = (-R(2.0)) - R(1.5)*p1;
            const bicycle_with_accelerometer_small_population_real i_det = (R(1.0)/((n0*n0) + p0*(n1*n1) - n0*n1*p1)); /* det N > 0 for every real J */
            const bicycle_with_accelerometer_small_population_real i0 = i_det*(n0 - n1*p1);
            const bicycle_with_accelerometer_small_population_real i1 = (-i_det*n1);
            const bicycle_with_accelerometer_small_population_real m0 = i0 - i1*p0;
            const bicycle_with_accelerometer_small_population_real m1 = i0 + i1 - i1*p1;
            const bicycle_with_accelerometer_small_population_real M_00 = m0 + J_00*m1; /* dx+/dx */
            const bicycle_with_accelerometer_small_population_real M_01 = J_01*m1;
            const bicycle_with_accelerometer_small_population_real M_10 = J_10*m1;
            const bicycle_with_accelerometer_small_population_real M_11 = m0 + J_11*m1;
            const bicycle_with_accelerometer_small_population_real g0 = h*i0 + R(0.5)*h*i1*p0;
            const bicycle_with_accelerometer_small_population_real g1 = h*i1 + R(0.5)*h*i1*p1 - R(0.5)*h*i0;
            const bicycle_with_accelerometer_small_population_real G_00 = g0 + J_00*g1; /* change per rate */
            const bicycle_with_accelerometer_small_population_real G_01 = J_01*g1;
            const bicycle_with_accelerometer_small_population_real G_10 = J_10*g1;
            const bicycle_with_accelerometer_small_population_real G_11 = g0 + J_11*g1;
            d_v_star = G_00*f_v_star + G_01*f_r_star; /* change over the step [-] */
            d_r_star = G_10*f_v_star + G_11*f_r_star; /* change over the step [-] */
            const bicycle_with_accelerometer_small_population_real F_v_star_K = G_00*f_v_star_K + G_01*f_r_star_K;
            const bicycle_with_accelerometer_small_population_real F_r_star_K = G_10*f_v_star_K + G_11*f_r_star_K;
            const bicycle_with_accelerometer_small_population_real F_v_star_pi1 = G_00*f_v_star_pi1 + G_01*f_r_star_pi1;
            const bicycle_with_accelerometer_small_population_real F_r_star_pi1 = G_10*f_v_star_pi1 + G_11*f_r_star_pi1;
            const bicycle_with_accelerometer_small_population_real F_v_star_eta = G_00*f_v_star_eta + G_01*f_r_star_eta;
            const bicycle_with_accelerometer_small_population_real F_r_star_eta = G_10*f_v_star_eta + G_11*f_r_star_eta;
            const bicycle_with_accelerometer_small_population_real F_v_star_rho = G_00*f_v_star_rho + G_01*f_r_star_rho;
            const bicycle_with_accelerometer_small_population_real F_r_star_rho = G_10*f_v_star_rho + G_11*f_r_star_rho;
            const bicycle_with_accelerometer_small_population_real F_v_star_lead = G_00*f_v_star_lead + G_01*f_r_star_lead;
            const bicycle_with_accelerometer_small_population_real F_r_star_lead = G_10*f_v_star_lead + G_11*f_r_star_lead;
            const bicycle_with_accelerometer_small_population_real F_v_star_u = G_00*f_v_star_u + G_01*f_r_star_u;
            const bicycle_with_accelerometer_small_population_real F_r_star_u = G_10*f_v_star_u + G_11*f_r_star_u;
            const bicycle_with_accelerometer_small_population_real ay_scale = inv_L*(at_U*at_U); /* ay = scale x dimensionless */
            const bicycle_with_accelerometer_small_population_real ay_per_step = ay_scale/h;
            const bicycle_with_accelerometer_small_population_real ay_to_0 = ay_per_step;
            const bicycle_with_accelerometer_small_population_real ay_from_0 = (-ay_per_step*ratio_v_star);
            const bicycle_with_accelerometer_small_population_real ay_to_1 = R(0.5)*ay_scale + ay_per_step*state->lead;
            const bicycle_with_accelerometer_small_population_real ay_from_1 = ratio_r_star*(R(0.5)*ay_scale - ay_per_step*state->lead);
            const bicycle_with_accelerometer_small_population_real ay_by_7 = ay_per_step*d_r_star;
            const bicycle_with_accelerometer_small_population_real F_v_star_v_star = M_00*ratio_v_star;
            const bicycle_with_accelerometer_small_population_real F_v_star_r_star = M_01*ratio_r_star;
            const bicycle_with_accelerometer_small_population_real F_r_star_v_star = M_10*ratio_v_star;
            const bicycle_with_accelerometer_small_population_real F_r_star_r_star = M_11*ratio_r_star;
            bicycle_with_accelerometer_small_population_propagate(config, state, held, F_v_star_K, F_v_star_eta, F_v_star_lead, F_v_star_pi1, F_v_star_r_star, F_v_star_rho, F_v_star_u, F_v_star_v_star, F_r_star_K, F_r_star_eta, F_r_star_lead, F_r_star_pi1, F_r_star_r_star, F_r_star_rho, F_r_star_u, F_r_star_v_star, ay_by_7, ay_from_0, ay_from_1, ay_to_0, ay_to_1, w_nominal);
            state->v_star = d_v_star + state->v_star;
            state->r_star = d_r_star + state->r_star;
        }
        move = R(0.0);
        if (state->excited <= R(0.0)) { /* nothing heard: it may have changed */
            const bicycle_with_accelerometer_small_population_real lost = ((R(1.0)) < (R(0.5)*sample->dt*config->idle_drift*config->prior_information) ? R(1.0) : R(0.5)*sample->dt*config->idle_drift*config->prior_information);
            const bicycle_with_accelerometer_small_population_real keep = R(1.0) - lost;
            diffusion = lost*(R(1.0) + keep)/(sample->dt*config->prior_information); /* for long: the prior variance */
            P[3] = P[3]*keep;
            P[12] = P[12]*keep;
            P[20] = P[20]*keep;
            P[27] = P[27]*keep;
            P[28] = P[28]*keep;
            P[29] = P[29]*keep;
            P[30] = P[30]*keep;
            P[31] = P[31]*keep;
            P[32] = P[32]*keep;
            P[33] = P[33]*keep;
            P[27] = P[27]*keep;
            const bicycle_with_accelerometer_small_population_real p = state->K - config->K_prior;
            const bicycle_with_accelerometer_small_population_real q = state->K + config->K_prior;
            const bicycle_with_accelerometer_small_population_real pp = (p*p);
            const bicycle_with_accelerometer_small_population_real qq = (q*q);
            const bicycle_with_accelerometer_small_population_real away = R(2.0)*p*(R(15.0)*qq - R(4.0)*pp)/(q*(R(15.0)*qq - R(9.0)*pp)); /* ln(K/K_prior) */
            move = (-away*lost);
            ay_with[3] = ay_with[3]*keep;
        } else {
            diffusion = config->drift + config->faint_drift*((R(0.0)) > (R(1.0) - state->heard*config->inv_telling) ? R(0.0) : R(1.0) - state->heard*config->inv_telling); /* a jump that could not have shown may have come */
        }
        P[27] = P[27] + sample->dt*(diffusion + state->jump*config->jump_drift);
        P[54] = P[54] + config->ay_bias_drift*sample->dt;
        P[52] = P[52] + config->bias_drift*sample->dt;
        const bicycle_with_accelerometer_small_population_real response = output_scale*state->r_star; /* output of the model */
        predicted = state->output_bias + response;
        const bicycle_with_accelerometer_small_population_real output_rate = d_r_star*inv_dt*output_scale;
        state->activity = state->activity + config->activity_rate*held*((response*response) - state->activity);
        const bicycle_with_accelerometer_small_population_real noise = state->noise_scale*(config->noise_variance + (output_rate*output_rate)*(config->timing_error*config->timing_error) + R(2.0)*state->activity*inv_dt*config->structure_time*(config->structure_share*config->structure_share)); /* variance of the measurement */
        const bicycle_with_accelerometer_small_population_real validity_now = inv_L*state->r_star*(at_U*at_U); /* lateral acceleration */
        const bicycle_with_accelerometer_small_population_real validity_then = state->validity*(R(1.0) - held*config->validity_rate);
        const bicycle_with_accelerometer_small_population_real validity_square = (validity_now*validity_now);
        state->validity = ((validity_square) > (validity_then) ? validity_square : validity_then);
        if (usable > 0) { /* measurement */
            const bicycle_with_accelerometer_small_population_real c_1 = P[17] + P[10]*output_scale;
            const bicycle_with_accelerometer_small_population_real c_3 = P[32] + P[12]*output_scale;
            const bicycle_with_accelerometer_small_population_real c_8 = P[52] + P[17]*output_scale;
            innovation = sample->measured - predicted;
            innovation_variance = c_8 + noise + c_1*output_scale;
            inv_spread = (R(1.0)/innovation_variance);
            const bicycle_with_accelerometer_small_population_real nis = inv_spread*(innovation*innovation); /* normalised innovation squared */
            if (nis > config->outlier_ratio) { /* an outlier counts for less */
                inv_spread = inv_spread*config->outlier_ratio/nis;
            }
            const bicycle_with_accelerometer_small_population_real odd = ((R(9.0)) < (nis) ? R(9.0) : nis) - R(1.0); /* by how much it is not as expected */
            linear = R(1.0); /* 1 in the model's linear range */
            if (state->validity >= (config->validity_limit*config->validity_limit)) {
                linear = R(0.0);
                if (status < 2) {
                    status = 2;
                }
            }
            state->surprise = state->surprise + held*config->surprise_rate*(R(1.0) + linear*odd - state->surprise); /* recent mean of the normalised innovation squared */
            const bicycle_with_accelerometer_small_population_real above = state->surprise - R(1.0);
            if ((above*above) > config->jump_ratio*state->restlessness) {
                state->jump = ((R(0.0)) > (state->surprise - config->surprise_limit) ? R(0.0) : state->surprise - config->surprise_limit);
            } else {
                state->jump = R(0.0);
            }
            const bicycle_with_accelerometer_small_population_real inv_P = (R(1.0)/P[27]);
            const bicycle_with_accelerometer_small_population_real sensitivity = c_3*inv_P; /* of the output to ln K */
            state->heard = state->heard*(R(1.0) - config->heard_rate*held) + inv_spread*(sensitivity*sensitivity); /* information of late */
            if (WITHIN(sample->ay_measured, config->ay_limit)) { /* ay is measured too */
                if ((WITHIN(state->last_ay, config->ay_limit)) && (anew < 1) && (sample->dt <= config->longest)) { /* and was, a sample before */
                    const bicycle_with_accelerometer_small_population_real ay_response = inv_L*(at_U*at_U)*(state->r_star + d_v_star/h + d_r_star*state->lead/h - R(0.5)*d_r_star); /* mean ay of the model over the sample */
                    state->ay_activity = state->ay_activity + config->activity_rate*held*((ay_response*ay_response) - state->ay_activity);
                    const bicycle_with_accelerometer_small_population_real ay_both = ay_with[8] + ay_with[1]*output_scale;
                    ay_after = ay_both*inv_spread; /* what the first output has said of it */
                    ay_innovation = R(0.5)*sample->ay_measured + R(0.5)*state->last_ay - state->ay_bias - ay_response - ay_after*innovation;
                    const bicycle_with_accelerometer_small_population_real ay_left = ((R(0.0)) > (state->ay_spread - ay_after*ay_both) ? R(0.0) : state->ay_spread - ay_after*ay_both); /* rounding may leave less than nothing */
                    ay_inv_spread = (R(1.0)/(ay_left + R(2.0)*state->ay_noise_scale*config->ay_time*inv_dt*(config->ay_variance + state->ay_activity*(config->ay_share*config->ay_share))));
                    const bicycle_with_accelerometer_small_population_real ay_nis = ay_inv_spread*(ay_innovation*ay_innovation); /* normalised innovation squared */
                    ay_odd = ((R(9.0)) < (ay_nis) ? R(9.0) : ay_nis) - R(1.0); /* by how much it is not as expected */
                    if (ay_nis > config->outlier_ratio) { /* an outlier counts for less */
                        ay_inv_spread = ay_inv_spread*config->outlier_ratio/ay_nis;
                    }
                } else {
                    ay_innovation = R(0.0);
                    ay_inv_spread = R(0.0);
                    ay_after = R(0.0);
                    ay_odd = R(0.0);
                }
                state->last_ay = sample->ay_measured;
            } else {
                ay_innovation = R(0.0);
                ay_inv_spread = R(0.0);
                ay_after = R(0.0);
                ay_odd = R(0.0);
                state->last_ay = R(2.0)*config->ay_limit;
            }
            const bicycle_with_accelerometer_small_population_real ay_c_3 = ay_with[3] - ay_after*c_3;
            if (state->excited > R(0.0)) { /* heard of the samples before */
                const bicycle_with_accelerometer_small_population_real learn_slow = (state->jump <= R(0.0) ? inv_spread : R(0.0)); /* a jump is not blamed on what cannot jump */
                const bicycle_with_accelerometer_small_population_real ay_learn_slow = (state->jump <= R(0.0) ? ay_inv_spread : R(0.0)); /* a jump is not blamed on what cannot jump */
                state->unlearnt = sample->dt + state->unlearnt;
                learn_seldom = R(0.0);
                ay_learn_seldom = R(0.0);
                if (state->unlearnt >= config->seldom) { /* the next sample tells little that this one does not */
                    learn_seldom = learn_slow;
                    ay_learn_seldom = ay_learn_slow;
                    state->unlearnt = R(0.0);
                }
                const bicycle_with_accelerometer_small_population_real gain_3 = c_3*inv_spread;
                const bicycle_with_accelerometer_small_population_real ay_gain_3 = ay_c_3*ay_inv_spread;
                const bicycle_with_accelerometer_small_population_real gained = inv_P*(ay_c_3*ay_gain_3 + c_3*gain_3); /* share of the variance removed */
                state->information = state->information + gained*inv_P*(R(1.0) + gained); /* 1/variance gained */
                move = move + ay_gain_3*ay_innovation + gain_3*innovation;
                bicycle_with_accelerometer_small_population_learn(state, output_scale, ay_after, learn_seldom, ay_learn_seldom, learn_slow, ay_learn_slow, ay_c_3, ay_gain_3, c_3, gain_3, ay_innovation, innovation);
                if (state->pi1 < config->pi1_low) { /* its allowed range */
                    state->pi1 = config->pi1_low;
                    status = 3;
                }
                if (state->eta < config->eta_low) { /* its allowed range */
                    state->eta = config->eta_low;
                    status = 3;
                }
                if (state->rho < config->rho_low) { /* its allowed range */
                    state->rho = config->rho_low;
                    status = 3;
                }
                if (state->pi1 > config->pi1_high) { /* its allowed range */
                    state->pi1 = config->pi1_high;
                    status = 3;
                }
                if (state->eta > config->eta_high) { /* its allowed range */
                    state->eta = config->eta_high;
                    status = 3;
                }
                if (state->rho > config->rho_high) { /* its allowed range */
                    state->rho = config->rho_high;
                    status = 3;
                }
            } else {
                if (status < 1) {
                    status = 1;
                }
            }
            bicycle_with_accelerometer_small_population_correct(state, output_scale, ay_after, c_1, c_8, inv_spread, ay_inv_spread, ay_c_3, c_3, ay_innovation, innovation);
            if (state->turn <= R(0.0)) { /* one for three samples */
                const bicycle_with_accelerometer_small_population_real expected = state->disturbance_scale*w_nominal; /* disturbance variance expected */
                const bicycle_with_accelerometer_small_population_real seen = ((R(9.0)*expected) < (P[19] + (state->disturbance*state->disturbance)) ? R(9.0)*expected : P[19] + (state->disturbance*state->disturbance)); /* and seen */
                const bicycle_with_accelerometer_small_population_real unseen = ((expected*config->observed_least) > (expected - P[19]) ? expected*config->observed_least : expected - P[19]);
                state->disturbance_scale = state->disturbance_scale + R(3.0)*config->disturbance_adapt*state->disturbance_scale*held*(seen - expected)/unseen;
                state->disturbance_scale = ((state->disturbance_scale) > (config->disturbance_scale_low) ? state->disturbance_scale : config->disturbance_scale_low);
                state->disturbance_scale = ((state->disturbance_scale) < (config->disturbance_scale_high) ? state->disturbance_scale : config->disturbance_scale_high);
                state->turn = R(1.0);
            } else {
                if (state->turn < R(1.5)) {
                    state->settling = ((config->noise_adapt) > (state->settling - R(3.0)*sample->dt*(state->settling*state->settling)) ? config->noise_adapt : state->settling - R(3.0)*sample->dt*(state->settling*state->settling)); /* 1/time at first */
                    const bicycle_with_accelerometer_small_population_real noise_change = odd*((R(0.05)) < (R(3.0)*sample->dt*state->settling) ? R(0.05) : R(3.0)*sample->dt*state->settling);
                    state->noise_scale = state->noise_scale*(R(1.0) + noise_change*(R(1.0) + R(0.5)*noise_change));
                    state->noise_scale = ((state->noise_scale) > (config->noise_scale_low) ? state->noise_scale : config->noise_scale_low);
                    state->noise_scale = ((state->noise_scale) < (config->noise_scale_high) ? state->noise_scale : config->noise_scale_high);
                    state->turn = R(2.0);
                } else {
                    state->restlessness = state->restlessness + R(3.0)*held*config->noise_adapt*((above*above) - state->restlessness);
                    state->excitation = state->excitation + R(3.0)*config->excitation_rate*held*((sensitivity*sensitivity) - state->excitation);
                    state->excited = (state->excitation > config->excitation_ratio*noise ? R(1.0) : R(0.0));
                    const bicycle_with_accelerometer_small_population_real ay_noise_change = ay_odd*((R(0.05)) < (R(3.0)*sample->dt*state->settling) ? R(0.05) : R(3.0)*sample->dt*state->settling);
                    state->ay_noise_scale = state->ay_noise_scale*(R(1.0) + ay_noise_change*(R(1.0) + R(0.5)*ay_noise_change));
                    state->ay_noise_scale = ((state->ay_noise_scale) > (config->ay_noise_scale_low) ? state->ay_noise_scale : config->ay_noise_scale_low);
                    state->ay_noise_scale = ((state->ay_noise_scale) < (config->ay_noise_scale_high) ? state->ay_noise_scale : config->ay_noise_scale_high);
                    state->turn = R(0.0);
                }
            }
        } else {
            innovation = R(0.0);
            innovation_variance = state->noise_scale*config->noise_variance;
            state->last_ay = R(2.0)*config->ay_limit;
        }
        const bicycle_with_accelerometer_small_population_real half_move = R(1.0) + move*(R(0.5) + R(0.125)*move);
        state->K = state->K*(half_move*half_move);
        state->last_input = u_now;
        state->last_U = at_U;
        if (usable > 0) {
            state->age = R(0.0);
            state->started = R(1.0);
            if (state->K < config->K_low) { /* its allowed range */
                state->K = config->K_low;
                status = 3;
            }
            if (state->K > config->K_high) { /* its allowed range */
                state->K = config->K_high;
                status = 3;
            }
        }
    } else {
        status = 7;
        state->age = (sample->dt > R(1.0) ? R(1000000.0) : state->age); /* an endless pause is a gap for the next sample */
        innovation = R(0.0);
        innovation_variance = state->noise_scale*config->noise_variance;
    }
    estimate = state->K;
    variance = P[27];
    information_gained = state->information;

    output->estimate = estimate;
    output->variance = variance;
    output->predicted = predicted;
    output->innovation = innovation;
    output->innovation_variance = innovation_variance;
    output->information_gained = information_gained;
    return status;
}

/* One sample: returns a status, never a NaN; the state stays usable whatever comes in. */
SIMILITUDE_API int bicycle_with_accelerometer_small_population_step(const bicycle_with_accelerometer_small_population_config *config, bicycle_with_accelerometer_small_population_state *state,
                               const bicycle_with_accelerometer_small_population_sample *sample, bicycle_with_accelerometer_small_population_output *output)
{
    return bicycle_with_accelerometer_small_population_advance(config, state, sample, output);
}

/* The step over n samples; the same bits as calling it n times. */
SIMILITUDE_API long bicycle_with_accelerometer_small_population_batch(const bicycle_with_accelerometer_small_population_config *config, bicycle_with_accelerometer_small_population_state *state, long n,
                                 const bicycle_with_accelerometer_small_population_sample *samples, bicycle_with_accelerometer_small_population_output *outputs, int *status)
{
    bicycle_with_accelerometer_small_population_state now = *state;
    long i;
    for (i = 0; i < n; ++i)
        status[i] = bicycle_with_accelerometer_small_population_advance(config, &now, &samples[i], &outputs[i]);
    *state = now;
    return n;
}
