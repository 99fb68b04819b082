"""Population filter of the bicycle_with_accelerometer: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle_with_accelerometer, Brennan & Alleyne 2004, eqs 1-4, with saturating tyres
base: m, L, U
unknowns: K, pi1, eta, rho, grip, place
coordinates: v_star, r_star, disturbance, K, pi1, eta, rho, grip, place, input_scale, input_offset, output_bias, ay_bias

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_with_accelerometer_population'
OPERATIONS = 2598
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ('v_star', 'r_star', 'disturbance', 'K', 'pi1', 'eta', 'rho', 'grip', 'place', 'input_scale', 'input_offset', 'output_bias', 'ay_bias')
REPORTS = False  # outputs are worked out when they are asked for, by a function of their own

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('K_prior', 'm^2/s^2', 'prior of Caf L/m, front cornering stiffness per mass and length', 1),
    ('pi1_prior', '-', 'prior of a/L, position of the centre of gravity', 1),
    ('eta_prior', '-', 'prior of rear over front cornering coefficient; > 1 understeers', 1),
    ('rho_prior', '-', 'prior of Iz/(m a b), yaw inertia ratio', 1),
    ('grip_prior', 'm/s^2', 'prior of mu g, greatest lateral acceleration', 1),
    ('place_prior', '-', 'prior of accelerometer behind the front axle over L', 1),
    ('P_prior', '-', "prior covariance of the unknowns' coordinates, upper triangle", 21),
    ('prior_information', '-', '1/prior variance of ln K', 1),
    ('K_low', 'm^2/s^2', 'lowest value the population allows', 1),
    ('K_high', 'm^2/s^2', 'highest value the population allows', 1),
    ('pi1_low', '-', 'lowest value the population allows', 1),
    ('pi1_high', '-', 'highest value the population allows', 1),
    ('eta_low', '-', 'lowest value the population allows', 1),
    ('eta_high', '-', 'highest value the population allows', 1),
    ('rho_low', '-', 'lowest value the population allows', 1),
    ('rho_high', '-', 'highest value the population allows', 1),
    ('grip_low', 'm/s^2', 'lowest value the population allows', 1),
    ('grip_high', 'm/s^2', 'highest value the population allows', 1),
    ('place_low', '-', 'lowest value the population allows', 1),
    ('place_high', '-', 'highest value the population allows', 1),
    ('input_scale_sd', '-', 'sd of the scale of delta, also that of the known scales', 1),
    ('input_scale_low', '-', 'least scale of delta', 1),
    ('input_scale_high', '-', 'greatest scale of delta', 1),
    ('input_offset_sd', 'rad', 'prior sd of the offset of delta', 1),
    ('output_bias_sd', 'rad/s', 'prior sd of the bias of r', 1),
    ('v_star_sd', '-', 'sd after a restart', 1),
    ('r_star_sd', '-', 'sd after a restart', 1),
    ('noise_variance', '(rad/s)^2', 'white noise of r a sample', 1),
    ('drift', '1/s', 'diffusion of ln K while it is observed', 1),
    ('idle_drift', '1/s', 'diffusion of ln K while nothing is heard of it', 1),
    ('jump_drift', '1/s', 'further diffusion per unit of surprise above its limit', 1),
    ('bias_drift', '(rad/s)^2/s', 'random walk of the output bias', 1),
    ('timing_error', 's', 'timing error between input and output', 1),
    ('companion_rate', '1/s', 'rate at which the uncorrected states follow the estimate', 1),
    ('offset_rate', '1/s', "rate at which the uncorrected states' offset follows the estimate", 1),
    ('structure_share', '-', "structural error as a share of the output's activity", 1),
    ('structure_time', 's', 'correlation time of the structural error', 1),
    ('activity_rate', '1/s', "averaging rate of the output's activity", 1),
    ('disturbance_floor', 'rad', 'disturbance at rest, equivalent input', 1),
    ('disturbance_share', '-', 'disturbance as a share of the dimensionless activity', 1),
    ('disturbance_rate', '1/s', '1/correlation time of the disturbance', 1),
    ('disturbance_adapt', '1/s', "adaptation rate of the disturbance's size", 1),
    ('disturbance_scale_start', '-', 'disturbance variance against nominal at the start', 1),
    ('disturbance_scale_low', '-', 'least disturbance variance against nominal', 1),
    ('disturbance_scale_high', '-', 'greatest disturbance variance against nominal', 1),
    ('noise_adapt', '1/s', "adaptation rate of the noise's size in the long run", 1),
    ('noise_scale_low', '-', 'least noise variance against nominal', 1),
    ('noise_scale_high', '-', 'greatest noise variance against nominal', 1),
    ('excitation_ratio', '-', 'least variance of sensitivity against noise to learn from', 1),
    ('excitation_rate', '1/s', 'averaging rate of the excitation', 1),
    ('seldom', 's', 'least time between samples that the seldom learnt unknowns learn from', 1),
    ('beyond_time', 's', 'beyond the linear range all but grip learn so seldom', 1),
    ('slow_doubt', '-', "share of ln K's variance from learnt constants that is added to it", 1),
    ('surprise_rate', '1/s', 'averaging rate of the normalised innovation', 1),
    ('jump_ratio', '-', 'squared surprise against its long-run mean that speaks of a jump', 1),
    ('surprise_limit', '-', 'mean squared normalised innovation that speaks of a jump', 1),
    ('heard_rate', '1/s', 'rate at which what was told of the first unknown is forgotten', 1),
    ('faint_drift', '1/s', 'further diffusion of ln K while a jump could not show', 1),
    ('inv_telling', '-', '1/information of late in which a jump shows', 1),
    ('observed_least', '-', 'least share of the disturbance taken as observed', 1),
    ('outlier_ratio', '-', 'squared innovation over its variance beyond which it is bounded', 1),
    ('gap', 's', 'longest time without a usable sample before a restart', 1),
    ('input_limit', 'rad', 'greatest believable delta', 1),
    ('output_limit', 'rad/s', 'greatest believable r', 1),
    ('signal_limit', 'm/s', 'greatest believable scale', 1),
    ('validity_limit', 'm/s^2', "edge of the model's linear range", 1),
    ('validity_rate', '1/s', 'decay rate of the memory of a visit outside the linear range', 1),
    ('ay_bias_sd', 'm/s^2', 'prior sd of the bias of ay', 1),
    ('ay_bias_drift', '(m/s^2)^2/s', 'random walk of the bias of ay', 1),
    ('ay_variance', '(m/s^2)^2', 'white noise of ay a sample', 1),
    ('ay_share', '-', 'structural error of ay as a share of it', 1),
    ('ay_time', 's', 'correlation time of what ay holds besides the model', 1),
    ('ay_noise_scale_low', '-', 'least noise variance of ay against nominal', 1),
    ('ay_noise_scale_high', '-', 'greatest noise variance of ay against nominal', 1),
    ('ay_limit', 'm/s^2', 'greatest believable ay', 1),
)

STATE = (
    ('v_star', '-', 'dimensionless state', 1),
    ('r_star', '-', 'dimensionless state', 1),
    ('v_star_plain', '-', 'the same, not corrected by measurements', 1),
    ('r_star_plain', '-', 'the same, not corrected by measurements', 1),
    ('input_offset_plain', 'rad', 'its offset: the estimated one, followed slowly', 1),
    ('disturbance', 'rad', 'disturbance as an equivalent delta', 1),
    ('K', 'm^2/s^2', 'Caf L/m, front cornering stiffness per mass and length', 1),
    ('pi1', '-', 'a/L, position of the centre of gravity', 1),
    ('eta', '-', 'rear over front cornering coefficient; > 1 understeers', 1),
    ('rho', '-', 'Iz/(m a b), yaw inertia ratio', 1),
    ('grip', 'm/s^2', 'mu g, greatest lateral acceleration', 1),
    ('place', '-', 'accelerometer behind the front axle over L', 1),
    ('input_scale', '-', 'delta that acts over delta measured', 1),
    ('input_offset', 'rad', 'offset of delta', 1),
    ('output_bias', 'rad/s', 'bias of r', 1),
    ('ay_bias', 'm/s^2', 'bias of ay', 1),
    ('ay_activity', '(m/s^2)^2', 'mean square of ay predicted', 1),
    ('ay_noise_scale', '-', 'noise variance of ay against nominal', 1),
    ('P', '-', 'covariance of the coordinates above, upper triangle by rows', 91),
    ('noise_scale', '-', 'noise variance against nominal', 1),
    ('disturbance_scale', '-', 'disturbance variance against nominal', 1),
    ('activity', '(rad/s)^2', 'mean square of the predicted output', 1),
    ('settling', '1/s', "adaptation rate of the noise's size now, fast at first", 1),
    ('restlessness', '-', 'long-run mean square of the surprise beyond one', 1),
    ('jump', '-', 'surprise taken as a jump of the first unknown', 1),
    ('surprise', '-', 'recent mean of the normalised innovation squared', 1),
    ('heard', '-', 'recent information about the first unknown', 1),
    ('excitation', '(rad/s)^2', 'mean square sensitivity to the first unknown', 1),
    ('excited', '-', '1 while the input excites the first unknown, else 0', 1),
    ('unlearnt', 's', 'time since the seldom learnt unknowns last learnt anything', 1),
    ('untaught', 's', 'time since a sample last taught more than grip', 1),
    ('validity', '(m/s^2)^2', 'recent peak of the validity signal, squared', 1),
    ('information', '-', 'information gained about ln K', 1),
    ('last_input', 'rad', 'input of the sample before', 1),
    ('last_U', 'm/s', 'forward speed of the sample before', 1),
    ('age', 's', 'time since the last usable sample', 1),
    ('started', '-', '1 once a sample was used; 0 again while the scales hide the dynamics', 1),
)

SAMPLE = (
    ('dt', 's', 'time since the sample before', 1),
    ('input', 'rad', 'road-wheel steer angle', 1),
    ('U', 'm/s', 'forward speed', 1),
    ('measured', 'rad/s', 'measured yaw rate', 1),
    ('ay_measured', 'm/s^2', 'measured lateral acceleration', 1),
)

OUTPUT = (
    ('estimate', 'm^2/s^2', 'Caf L/m, front cornering stiffness per mass and length', 1),
    ('variance', '-', 'variance of ln K', 1),
    ('predicted', 'rad/s', 'yaw rate predicted before the measurement', 1),
    ('innovation', 'rad/s', 'measured minus predicted; 0 without a measurement', 1),
    ('innovation_variance', '(rad/s)^2', 'variance of the innovation', 1),
    ('information_gained', '-', 'information gained about ln K so far', 1),
    ('own_variance', '-', 'variance of ln K that the filter goes by', 1),
    ('pi1_now', '-', 'a/L, position of the centre of gravity', 1),
    ('eta_now', '-', 'rear over front cornering coefficient; > 1 understeers', 1),
    ('rho_now', '-', 'Iz/(m a b), yaw inertia ratio', 1),
    ('grip_now', 'm/s^2', 'mu g, greatest lateral acceleration', 1),
    ('place_now', '-', 'accelerometer behind the front axle over L', 1),
    ('offset_now', 'rad', 'offset of delta', 1),
    ('bias_now', 'rad/s', 'bias of r', 1),
    ('noise_now', '(rad/s)^2', 'variance of the measurement', 1),
    ('disturbance_now', '(rad)^2', 'variance of the disturbance in the long run', 1),
)


def init(config):
    """The flat state before the first sample, from the flat configuration."""
    K_prior = config[1]
    pi1_prior = config[2]
    eta_prior = config[3]
    rho_prior = config[4]
    grip_prior = config[5]
    place_prior = config[6]
    P_prior_0 = config[7]
    P_prior_1 = config[8]
    P_prior_2 = config[9]
    P_prior_3 = config[10]
    P_prior_4 = config[11]
    P_prior_5 = config[12]
    P_prior_6 = config[13]
    P_prior_7 = config[14]
    P_prior_8 = config[15]
    P_prior_9 = config[16]
    P_prior_10 = config[17]
    P_prior_11 = config[18]
    P_prior_12 = config[19]
    P_prior_13 = config[20]
    P_prior_14 = config[21]
    P_prior_15 = config[22]
    P_prior_16 = config[23]
    P_prior_17 = config[24]
    P_prior_18 = config[25]
    P_prior_19 = config[26]
    P_prior_20 = config[27]
    input_scale_sd = config[41]
    input_offset_sd = config[44]
    output_bias_sd = config[45]
    v_star_sd = config[46]
    r_star_sd = config[47]
    disturbance_floor = config[59]
    disturbance_scale_start = config[63]
    ay_bias_sd = config[88]
    v_star = 0.0
    r_star = 0.0
    v_star_plain = 0.0
    r_star_plain = 0.0
    disturbance = 0.0
    K = K_prior
    pi1 = pi1_prior
    eta = eta_prior
    rho = rho_prior
    grip = grip_prior
    place = place_prior
    input_scale = 1.0
    input_offset = 0.0
    output_bias = 0.0
    P_0 = 0.0
    P_1 = 0.0
    P_2 = 0.0
    P_3 = 0.0
    P_4 = 0.0
    P_5 = 0.0
    P_6 = 0.0
    P_7 = 0.0
    P_8 = 0.0
    P_9 = 0.0
    P_10 = 0.0
    P_11 = 0.0
    P_12 = 0.0
    P_13 = 0.0
    P_14 = 0.0
    P_15 = 0.0
    P_16 = 0.0
    P_17 = 0.0
    P_18 = 0.0
    P_19 = 0.0
    P_20 = 0.0
    P_21 = 0.0
    P_22 = 0.0
    P_23 = 0.0
    P_24 = 0.0
    P_25 = 0.0
    P_26 = 0.0
    P_27 = 0.0
    P_28 = 0.0
    P_29 = 0.0
    P_30 = 0.0
    P_31 = 0.0
    P_32 = 0.0
    P_33 = 0.0
    P_34 = 0.0
    P_35 = 0.0
    P_36 = 0.0
    P_37 = 0.0
    P_38 = 0.0
    P_39 = 0.0
    P_40 = 0.0
    P_41 = 0.0
    P_42 = 0.0
    P_43 = 0.0
    P_44 = 0.0
    P_45 = 0.0
    P_46 = 0.0
    P_47 = 0.0
    P_48 = 0.0
    P_49 = 0.0
    P_50 = 0.0
    P_51 = 0.0
    P_52 = 0.0
    P_53 = 0.0
    P_54 = 0.0
    P_55 = 0.0
    P_56 = 0.0
    P_57 = 0.0
    P_58 = 0.0
    P_59 = 0.0
    P_60 = 0.0
    P_61 = 0.0
    P_62 = 0.0
    P_63 = 0.0
    P_64 = 0.0
    P_65 = 0.0
    P_66 = 0.0
    P_67 = 0.0
    P_68 = 0.0
    P_69 = 0.0
    P_70 = 0.0
    P_71 = 0.0
    P_72 = 0.0
    P_73 = 0.0
    P_74 = 0.0
    P_75 = 0.0
    P_76 = 0.0
    P_77 = 0.0
    P_78 = 0.0
    P_79 = 0.0
    P_80 = 0.0
    P_81 = 0.0
    P_82 = 0.0
    P_83 = 0.0
    P_84 = 0.0
    P_85 = 0.0
    P_86 = 0.0
    P_87 = 0.0
    P_88 = 0.0
    P_89 = 0.0
    P_90 = 0.0
    P_0 = (v_star_sd*v_star_sd)
    P_13 = (r_star_sd*r_star_sd)
    P_81 = (input_scale_sd*input_scale_sd)
    P_85 = (input_offset_sd*input_offset_sd)
    P_88 = (output_bias_sd*output_bias_sd)
    P_90 = (ay_bias_sd*ay_bias_sd)
    P_36 = P_prior_0
    P_37 = P_prior_1
    P_38 = P_prior_2
    P_39 = P_prior_3
    P_40 = P_prior_4
    P_41 = P_prior_5
    P_46 = P_prior_6
    P_47 = P_prior_7
    P_48 = P_prior_8
    P_49 = P_prior_9
    P_50 = P_prior_10
    P_55 = P_prior_11
    P_56 = P_prior_12
    P_57 = P_prior_13
    P_58 = P_prior_14
    P_63 = P_prior_15
    P_64 = P_prior_16
    P_65 = P_prior_17
    P_70 = P_prior_18
    P_71 = P_prior_19
    P_76 = P_prior_20
    noise_scale = 1.0
    surprise = 1.0
    settling = 1.0
    disturbance_scale = disturbance_scale_start
    ay_noise_scale = 1.0
    P_25 = disturbance_scale*(disturbance_floor*disturbance_floor)
    restlessness = 0.0
    jump = 0.0
    heard = 0.0
    activity = 0.0
    excitation = 0.0
    excited = 0.0
    unlearnt = 0.0
    validity = 0.0
    information = 0.0
    last_input = 0.0
    age = 0.0
    started = 0.0
    untaught = 0.0
    last_U = 0.0
    ay_bias = 0.0
    ay_activity = 0.0
    input_offset_plain = 0.0
    return [v_star, r_star, v_star_plain, r_star_plain, input_offset_plain, disturbance, K, pi1, eta, rho, grip, place, input_scale, input_offset, output_bias, ay_bias, ay_activity, ay_noise_scale, P_0, P_1, P_2, P_3, P_4, P_5, P_6, P_7, P_8, P_9, P_10, P_11, P_12, P_13, P_14, P_15, P_16, P_17, P_18, P_19, P_20, P_21, P_22, P_23, P_24, P_25, P_26, P_27, P_28, P_29, P_30, P_31, P_32, P_33, P_34, P_35, P_36, P_37, P_38, P_39, P_40, P_41, P_42, P_43, P_44, P_45, P_46, P_47, P_48, P_49, P_50, P_51, P_52, P_53, P_54, P_55, P_56, P_57, P_58, P_59, P_60, P_61, P_62, P_63, P_64, P_65, P_66, P_67, P_68, P_69, P_70, P_71, P_72, P_73, P_74, P_75, P_76, P_77, P_78, P_79, P_80, P_81, P_82, P_83, P_84, P_85, P_86, P_87, P_88, P_89, P_90, noise_scale, disturbance_scale, activity, settling, restlessness, jump, surprise, heard, excitation, excited, unlearnt, untaught, validity, information, last_input, last_U, age, started]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    L = config[0]
    K_prior = config[1]
    prior_information = config[28]
    K_low = config[29]
    K_high = config[30]
    pi1_low = config[31]
    pi1_high = config[32]
    eta_low = config[33]
    eta_high = config[34]
    rho_low = config[35]
    rho_high = config[36]
    grip_low = config[37]
    grip_high = config[38]
    place_low = config[39]
    place_high = config[40]
    input_scale_low = config[42]
    input_scale_high = config[43]
    v_star_sd = config[46]
    r_star_sd = config[47]
    noise_variance = config[48]
    drift = config[49]
    idle_drift = config[50]
    jump_drift = config[51]
    bias_drift = config[52]
    timing_error = config[53]
    companion_rate = config[54]
    offset_rate = config[55]
    structure_share = config[56]
    structure_time = config[57]
    activity_rate = config[58]
    disturbance_floor = config[59]
    disturbance_share = config[60]
    disturbance_rate = config[61]
    disturbance_adapt = config[62]
    disturbance_scale_low = config[64]
    disturbance_scale_high = config[65]
    noise_adapt = config[66]
    noise_scale_low = config[67]
    noise_scale_high = config[68]
    excitation_ratio = config[69]
    excitation_rate = config[70]
    seldom = config[71]
    beyond_time = config[72]
    slow_doubt = config[73]
    surprise_rate = config[74]
    jump_ratio = config[75]
    surprise_limit = config[76]
    heard_rate = config[77]
    faint_drift = config[78]
    inv_telling = config[79]
    observed_least = config[80]
    outlier_ratio = config[81]
    gap = config[82]
    input_limit = config[83]
    output_limit = config[84]
    signal_limit = config[85]
    validity_limit = config[86]
    validity_rate = config[87]
    ay_bias_drift = config[89]
    ay_variance = config[90]
    ay_share = config[91]
    ay_time = config[92]
    ay_noise_scale_low = config[93]
    ay_noise_scale_high = config[94]
    ay_limit = config[95]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    ay_measured = sample[4]
    v_star = state[0]
    r_star = state[1]
    v_star_plain = state[2]
    r_star_plain = state[3]
    input_offset_plain = state[4]
    disturbance = state[5]
    K = state[6]
    pi1 = state[7]
    eta = state[8]
    rho = state[9]
    grip = state[10]
    place = state[11]
    input_scale = state[12]
    input_offset = state[13]
    output_bias = state[14]
    ay_bias = state[15]
    ay_activity = state[16]
    ay_noise_scale = state[17]
    P_0 = state[18]
    P_1 = state[19]
    P_2 = state[20]
    P_3 = state[21]
    P_4 = state[22]
    P_5 = state[23]
    P_6 = state[24]
    P_7 = state[25]
    P_8 = state[26]
    P_9 = state[27]
    P_10 = state[28]
    P_11 = state[29]
    P_12 = state[30]
    P_13 = state[31]
    P_14 = state[32]
    P_15 = state[33]
    P_16 = state[34]
    P_17 = state[35]
    P_18 = state[36]
    P_19 = state[37]
    P_20 = state[38]
    P_21 = state[39]
    P_22 = state[40]
    P_23 = state[41]
    P_24 = state[42]
    P_25 = state[43]
    P_26 = state[44]
    P_27 = state[45]
    P_28 = state[46]
    P_29 = state[47]
    P_30 = state[48]
    P_31 = state[49]
    P_32 = state[50]
    P_33 = state[51]
    P_34 = state[52]
    P_35 = state[53]
    P_36 = state[54]
    P_37 = state[55]
    P_38 = state[56]
    P_39 = state[57]
    P_40 = state[58]
    P_41 = state[59]
    P_42 = state[60]
    P_43 = state[61]
    P_44 = state[62]
    P_45 = state[63]
    P_46 = state[64]
    P_47 = state[65]
    P_48 = state[66]
    P_49 = state[67]
    P_50 = state[68]
    P_51 = state[69]
    P_52 = state[70]
    P_53 = state[71]
    P_54 = state[72]
    P_55 = state[73]
    P_56 = state[74]
    P_57 = state[75]
    P_58 = state[76]
    P_59 = state[77]
    P_60 = state[78]
    P_61 = state[79]
    P_62 = state[80]
    P_63 = state[81]
    P_64 = state[82]
    P_65 = state[83]
    P_66 = state[84]
    P_67 = state[85]
    P_68 = state[86]
    P_69 = state[87]
    P_70 = state[88]
    P_71 = state[89]
    P_72 = state[90]
    P_73 = state[91]
    P_74 = state[92]
    P_75 = state[93]
    P_76 = state[94]
    P_77 = state[95]
    P_78 = state[96]
    P_79 = state[97]
    P_80 = state[98]
    P_81 = state[99]
    P_82 = state[100]
    P_83 = state[101]
    P_84 = state[102]
    P_85 = state[103]
    P_86 = state[104]
    P_87 = state[105]
    P_88 = state[106]
    P_89 = state[107]
    P_90 = state[108]
    noise_scale = state[109]
    disturbance_scale = state[110]
    activity = state[111]
    settling = state[112]
    restlessness = state[113]
    jump = state[114]
    surprise = state[115]
    heard = state[116]
    excitation = state[117]
    excited = state[118]
    unlearnt = state[119]
    untaught = state[120]
    validity = state[121]
    information = state[122]
    last_input = state[123]
    last_U = state[124]
    age = state[125]
    started = state[126]
    U_now = 0.0
    anew = 0.0
    ay_inv_spread = 0.0
    bias_now = 0.0
    diffusion = 0.0
    disturbance_now = 0.0
    estimate = 0.0
    eta_now = 0.0
    grip_now = 0.0
    information_gained = 0.0
    innovation = 0.0
    innovation_variance = 0.0
    inv_spread = 0.0
    move = 0.0
    noise_now = 0.0
    offset_now = 0.0
    own_variance = 0.0
    pi1_now = 0.0
    place_now = 0.0
    predicted = 0.0
    rho_now = 0.0
    status = 0.0
    u_now = 0.0
    usable = 0.0
    variance = 0.0
    status = 0.0
    predicted = output_bias
    innovation = 0.0
    innovation_variance = noise_scale*noise_variance
    noise_now = innovation_variance
    disturbance_now = disturbance_scale*(disturbance_floor*disturbance_floor)
    if (dt < 1000000.0) and (dt > 1e-06):  # time must advance
        usable = 1.0
        anew = 0.0  # 1 where the dynamic state starts anew
        age = age + dt
        if abs(input) < input_limit:  # a missing one is held
            u_now = input
        else:
            u_now = last_input
            usable = 0.0
            status = 4.0
        if abs(U) < signal_limit:  # a missing one is held
            U_now = U
        else:
            U_now = last_U
            usable = 0.0
            status = 4.0
        if abs(measured) < output_limit:  # no measurement
            pass
        else:
            usable = 0.0
            status = 4.0
        if started < 0.5:  # no sample before it could be used
            anew = 1.0
            last_input = u_now
            last_U = U_now
        if (age > gap) and (usable > 0.5):  # the first sample after a gap
            status = 5.0
            anew = 1.0
        if (10.0*(U_now*U_now) > K_prior) and (U_now > 0.0):  # the dynamics cannot be seen
            pass
        else:
            anew = 1.0
            started = 0.0
            usable = 0.0
            status = 6.0
        if (age > gap) or (anew > 0.5):  # nothing was heard for long
            excitation = 0.0
            excited = 0.0
            jump = 0.0
            heard = 0.0
            surprise = 1.0
        if anew > 0.5:  # nothing is known of them
            P_0 = 0.0
            P_1 = 0.0
            P_2 = 0.0
            P_3 = 0.0
            P_4 = 0.0
            P_5 = 0.0
            P_6 = 0.0
            P_7 = 0.0
            P_8 = 0.0
            P_9 = 0.0
            P_10 = 0.0
            P_11 = 0.0
            P_12 = 0.0
            P_13 = 0.0
            P_14 = 0.0
            P_15 = 0.0
            P_16 = 0.0
            P_17 = 0.0
            P_18 = 0.0
            P_19 = 0.0
            P_20 = 0.0
            P_21 = 0.0
            P_22 = 0.0
            P_23 = 0.0
            P_24 = 0.0
            P_25 = 0.0
            P_26 = 0.0
            P_27 = 0.0
            P_28 = 0.0
            P_29 = 0.0
            P_30 = 0.0
            P_31 = 0.0
            P_32 = 0.0
            P_33 = 0.0
            P_34 = 0.0
            P_35 = 0.0
            P_0 = (v_star_sd*v_star_sd)
            P_13 = (r_star_sd*r_star_sd)
            P_25 = disturbance_scale*(disturbance_floor*disturbance_floor)
            v_star = 0.0
            r_star = 0.0
            v_star_plain = 0.0
            r_star_plain = 0.0
            disturbance = 0.0
        least_scale = 0.0003333333333333333*signal_limit
        at_U = (U_now if (U_now) > (least_scale) else least_scale)  # kept off zero
        was_U = (last_U if (last_U) > (least_scale) else least_scale)
        inv_U = (1.0/at_U)
        inv_L = (1.0/L)
        inv_dt = (1.0/dt)
        output_scale = at_U*inv_L  # r = scale x dimensionless
        inv_output_scale = L*inv_U
        span = (dt if dt < gap else 0.0)  # [s] the dynamics start anew at the end of a gap
        h = at_U*inv_L*span  # dimensionless time step
        ratio_v_star = inv_U*was_U  # same physical state in the new scales
        v_star = ratio_v_star*v_star
        v_star_plain = ratio_v_star*v_star_plain
        ratio_r_star = inv_U*was_U  # same physical state in the new scales
        r_star = r_star*ratio_r_star
        r_star_plain = r_star_plain*ratio_r_star
        steer = 0.5*input_scale*(last_input + u_now)  # mean of the sample's two ends
        steer_change = input_scale*(u_now - last_input)
        u_plain = input_offset_plain + steer  # measured input less its offset [-]
        u = disturbance + input_offset + steer  # effective input [-]
        inv0 = (1.0/grip)
        inv1 = (1.0/rho)
        inv2 = (1.0/(pi1 - 1.0))
        s0 = v_star + pi1*r_star
        s1 = K*inv0*inv2*inv_L
        s2 = v_star_plain + pi1*r_star_plain
        s3 = eta*s1
        load0 = s1*(s0 - u)  # force over its limit [-]
        load1 = s1*(s2 - u_plain)  # force over its limit [-]
        load2 = s3*(s0 - r_star)  # force over its limit [-]
        load3 = s3*(s2 - r_star_plain)  # force over its limit [-]
        size0 = ((-load0) if ((-load0)) > (load0) else load0)
        over0 = 1.0 + size0*(1.0 + 0.7*size0)
        part0 = (1.0/(1.0 + over0*size0))  # force over load
        size1 = ((-load1) if ((-load1)) > (load1) else load1)
        over1 = 1.0 + size1*(1.0 + 0.7*size1)
        part1 = (1.0/(1.0 + over1*size1))
        size2 = ((-load2) if ((-load2)) > (load2) else load2)
        over2 = 1.0 + size2*(1.0 + 0.7*size2)
        part2 = (1.0/(1.0 + over2*size2))
        size3 = ((-load3) if ((-load3)) > (load3) else load3)
        over3 = 1.0 + size3*(1.0 + 0.7*size3)
        part3 = (1.0/(1.0 + over3*size3))
        c0 = load0*over0*part0
        c1 = load2*over2*part2
        c2 = L*(inv_U*inv_U)
        c3 = c2*grip
        c4 = c3*inv1
        c5 = load1*over1*part1
        c6 = load3*over3*part3
        c7 = c6*pi1
        c8 = c5 - c6
        c9 = c4*c8
        c10 = (part0*part0)
        c11 = 1.0 + size0*(2.0 + 2.1*size0)
        c12 = c10*c11
        c13 = eta*(part2*part2)*(1.0 + size2*(2.0 + 2.1*size2))
        c14 = 0.16666666666666666*h
        c15 = K*inv_L
        c16 = c15*inv2
        c17 = c16*c2
        c18 = c13 - c10*c11*inv2*pi1
        c19 = c15*c2
        c20 = c19*pi1
        c21 = c17*inv1
        c22 = c19*inv1
        c23 = v_star_plain + pi1*r_star_plain
        c24 = c23 - u_plain
        c25 = (part1*part1)
        c26 = 1.0 + size1*(2.0 + 2.1*size1)
        c27 = c25*c26
        c28 = c24*c27
        c29 = (-r_star_plain)
        c30 = c23 + c29
        c31 = eta*(part3*part3)*(1.0 + size3*(2.0 + 2.1*size3))
        c32 = c30*c31
        c33 = c28 + c32*pi1 - c24*c25*c26*pi1
        c34 = c32 - c28
        c35 = (-c5)
        c36 = (-c29) - c24*inv2
        c37 = c16*inv0
        c38 = c30*inv2
        c39 = c31*((-c29) - c38)
        c40 = c31*c38
        f_v_star = (-r_star) - c3*(load0*over0*part0*pi1 - c0 - c1*pi1)  # rate [-]
        f_r_star = c4*(c0 - c1)  # rate [-]
        f_v_star_plain = (-r_star_plain) - c3*(load1*over1*part1*pi1 - c5 - c7)
        f_r_star_plain = c9
        J_00 = (-c14*c17*(c10*c11*pi1 - c12 - c13*pi1))
        J_01 = (-c14*(1.0 + c20*((-c18) - c12*inv2)))
        J_10 = c14*c21*(c12 - c13)
        J_11 = (-c14*c18*c22)
        f_v_star_K = c17*c33
        f_r_star_K = (-c21*c34)
        f_v_star_pi1 = (-c3*(K*c25*c26*c36*inv0*inv2*inv_L*pi1 - c35 - c6 - c27*c36*c37 - c37*c39*pi1))
        f_r_star_pi1 = c21*(c25*c26*c36 - c39)
        f_v_star_eta = c20*c40
        f_r_star_eta = (-c22*c40)
        f_v_star_rho = 0.0
        f_r_star_rho = (-c9)
        f_v_star_grip = (-c3*(c35 + c33*c37 + c5*pi1 - c7))
        f_r_star_grip = c4*(c8 + c34*c37)
        f_v_star_place = 0.0
        f_r_star_place = 0.0
        f_v_star_u = (-c17*c27*(1.0 - pi1))
        f_r_star_u = (-c21*c27)
        p0 = J_00*J_11 - J_01*J_10
        p1 = (-J_00) - J_11
        n0 = 1.0 - 1.5*p0
        n1 = (-2.0) - 1.5*p1
        i_det = (1.0/((n0*n0) + p0*(n1*n1) - n0*n1*p1))  # det N > 0 for every real J
        i0 = i_det*(n0 - n1*p1)
        i1 = (-i_det*n1)
        E0 = i0 - i1*p0  # half a step
        E1 = i0 + i1 - i1*p1
        H0 = 0.5*h*i0 + 0.25*h*i1*p0  # change per rate over half a step
        H1 = 0.5*h*i1 + 0.25*h*i1*p1 - 0.25*h*i0
        m0 = (E0*E0) - p0*(E1*E1)
        m1 = 2.0*E0*E1 - p1*(E1*E1)
        g0 = H0*(1.0 + E0) - E1*H1*p0
        g1 = E1*H0 + H1*(1.0 + E0) - E1*H1*p1
        wi0 = (-p0*(0.4375 + 0.1875*p1))
        wi1 = 0.1875*p0 - 0.5 - p1*(0.4375 + 0.1875*p1)
        wh0 = i0*wi0 - i1*p0*wi1
        wh1 = i0*wi1 + i1*wi0 - i1*p1*wi1
        w0 = i0*wh0 - i1*p0*wh1  # W/h in powers of J
        w1 = i0*wh1 + i1*wh0 - i1*p1*wh1
        M_00 = m0 + J_00*m1  # dx+/dx
        M_01 = J_01*m1
        M_10 = J_10*m1
        M_11 = m0 + J_11*m1
        G_00 = g0 + J_00*g1  # change per rate
        G_01 = J_01*g1
        G_10 = J_10*g1
        G_11 = g0 + J_11*g1
        ramp = h*steer_change
        ramp_0 = ramp*w0
        ramp_1 = ramp*w1
        slope1_v_star = J_00*f_v_star_u + J_01*f_r_star_u
        slope1_r_star = J_10*f_v_star_u + J_11*f_r_star_u
        rise_v_star = f_v_star_u*ramp_0 + ramp_1*slope1_v_star  # the input rises or falls in a straight line [-]
        rise_r_star = f_r_star_u*ramp_0 + ramp_1*slope1_r_star
        d_v_star = rise_v_star + G_00*f_v_star + G_01*f_r_star  # change over the step [-]
        d_r_star = rise_r_star + G_10*f_v_star + G_11*f_r_star  # change over the step [-]
        d_v_star_plain = rise_v_star + G_00*f_v_star_plain + G_01*f_r_star_plain
        d_r_star_plain = rise_r_star + G_10*f_v_star_plain + G_11*f_r_star_plain
        F_v_star_K = G_00*f_v_star_K + G_01*f_r_star_K
        F_r_star_K = G_10*f_v_star_K + G_11*f_r_star_K
        F_v_star_pi1 = G_00*f_v_star_pi1 + G_01*f_r_star_pi1
        F_r_star_pi1 = G_10*f_v_star_pi1 + G_11*f_r_star_pi1
        F_v_star_eta = G_00*f_v_star_eta + G_01*f_r_star_eta
        F_r_star_eta = G_10*f_v_star_eta + G_11*f_r_star_eta
        F_v_star_rho = G_00*f_v_star_rho + G_01*f_r_star_rho
        F_r_star_rho = G_10*f_v_star_rho + G_11*f_r_star_rho
        F_v_star_grip = G_00*f_v_star_grip + G_01*f_r_star_grip
        F_r_star_grip = G_10*f_v_star_grip + G_11*f_r_star_grip
        F_v_star_place = G_00*f_v_star_place + G_01*f_r_star_place
        F_r_star_place = G_10*f_v_star_place + G_11*f_r_star_place
        F_v_star_u = G_00*f_v_star_u + G_01*f_r_star_u
        F_r_star_u = G_10*f_v_star_u + G_11*f_r_star_u
        keep_w = (0.0 if (0.0) > (1.0 - disturbance_rate*dt) else 1.0 - disturbance_rate*dt)
        w_nominal = (disturbance_floor*disturbance_floor) + activity*(disturbance_share*disturbance_share)*(inv_output_scale*inv_output_scale)  # nominal variance of the disturbance
        move = 0.0
        diffusion = drift + faint_drift*(0.0 if (0.0) > (1.0 - heard*inv_telling) else 1.0 - heard*inv_telling)  # a jump that could not have shown may have come
        if excited < 0.5:  # nothing heard: it may have changed, and the population is the best guess
            lost = (1.0 if (1.0) < (0.5*dt*idle_drift*prior_information) else 0.5*dt*idle_drift*prior_information)
            keep = 1.0 - lost
            diffusion = lost*(1.0 + keep)/(dt*prior_information)  # for long: the prior variance
            P_3 = P_3*keep
            P_15 = P_15*keep
            P_26 = P_26*keep
            P_36 = P_36*keep
            P_37 = P_37*keep
            P_38 = P_38*keep
            P_39 = P_39*keep
            P_40 = P_40*keep
            P_41 = P_41*keep
            P_42 = P_42*keep
            P_43 = P_43*keep
            P_44 = P_44*keep
            P_45 = P_45*keep
            P_36 = P_36*keep
            p = K - K_prior
            q = K + K_prior
            pp = (p*p)
            qq = (q*q)
            away = 2.0*p*(15.0*qq - 4.0*pp)/(q*(15.0*qq - 9.0*pp))  # ln(K/K_prior)
            move = (-away*lost)
        F_v_star_v_star = M_00*ratio_v_star
        F_v_star_r_star = M_01*ratio_r_star
        F_r_star_v_star = M_10*ratio_v_star
        F_r_star_r_star = M_11*ratio_r_star
        PW_0 = P_10 + P_2 + P_9*steer
        FP_0_0 = F_v_star_K*P_3 + F_v_star_eta*P_5 + F_v_star_grip*P_7 + F_v_star_pi1*P_4 + F_v_star_place*P_8 + F_v_star_r_star*P_1 + F_v_star_rho*P_6 + F_v_star_u*PW_0 + F_v_star_v_star*P_0
        FP_1_0 = F_r_star_K*P_3 + F_r_star_eta*P_5 + F_r_star_grip*P_7 + F_r_star_pi1*P_4 + F_r_star_place*P_8 + F_r_star_r_star*P_1 + F_r_star_rho*P_6 + F_r_star_u*PW_0 + F_r_star_v_star*P_0
        PW_1 = P_14 + P_22 + P_21*steer
        FP_0_1 = F_v_star_K*P_15 + F_v_star_eta*P_17 + F_v_star_grip*P_19 + F_v_star_pi1*P_16 + F_v_star_place*P_20 + F_v_star_r_star*P_13 + F_v_star_rho*P_18 + F_v_star_u*PW_1 + F_v_star_v_star*P_1
        FP_1_1 = F_r_star_K*P_15 + F_r_star_eta*P_17 + F_r_star_grip*P_19 + F_r_star_pi1*P_16 + F_r_star_place*P_20 + F_r_star_r_star*P_13 + F_r_star_rho*P_18 + F_r_star_u*PW_1 + F_r_star_v_star*P_1
        P_0 = FP_0_0*F_v_star_v_star + FP_0_1*F_v_star_r_star
        P_1 = FP_0_0*F_r_star_v_star + FP_0_1*F_r_star_r_star
        P_13 = FP_1_0*F_r_star_v_star + FP_1_1*F_r_star_r_star
        PW_2 = P_25 + P_33 + P_32*steer
        FP_0_2 = F_v_star_K*P_26 + F_v_star_eta*P_28 + F_v_star_grip*P_30 + F_v_star_pi1*P_27 + F_v_star_place*P_31 + F_v_star_r_star*P_14 + F_v_star_rho*P_29 + F_v_star_u*PW_2 + F_v_star_v_star*P_2
        FP_1_2 = F_r_star_K*P_26 + F_r_star_eta*P_28 + F_r_star_grip*P_30 + F_r_star_pi1*P_27 + F_r_star_place*P_31 + F_r_star_r_star*P_14 + F_r_star_rho*P_29 + F_r_star_u*PW_2 + F_r_star_v_star*P_2
        P_2 = FP_0_2*keep_w
        P_14 = FP_1_2*keep_w
        PW_3 = P_26 + P_43 + P_42*steer
        FP_0_3 = F_v_star_K*P_36 + F_v_star_eta*P_38 + F_v_star_grip*P_40 + F_v_star_pi1*P_37 + F_v_star_place*P_41 + F_v_star_r_star*P_15 + F_v_star_rho*P_39 + F_v_star_u*PW_3 + F_v_star_v_star*P_3
        FP_1_3 = F_r_star_K*P_36 + F_r_star_eta*P_38 + F_r_star_grip*P_40 + F_r_star_pi1*P_37 + F_r_star_place*P_41 + F_r_star_r_star*P_15 + F_r_star_rho*P_39 + F_r_star_u*PW_3 + F_r_star_v_star*P_3
        P_3 = FP_0_3
        P_15 = FP_1_3
        P_0 = P_0 + FP_0_3*F_v_star_K
        P_1 = P_1 + FP_0_3*F_r_star_K
        P_13 = P_13 + FP_1_3*F_r_star_K
        PW_4 = P_27 + P_52 + P_51*steer
        FP_0_4 = F_v_star_K*P_37 + F_v_star_eta*P_47 + F_v_star_grip*P_49 + F_v_star_pi1*P_46 + F_v_star_place*P_50 + F_v_star_r_star*P_16 + F_v_star_rho*P_48 + F_v_star_u*PW_4 + F_v_star_v_star*P_4
        FP_1_4 = F_r_star_K*P_37 + F_r_star_eta*P_47 + F_r_star_grip*P_49 + F_r_star_pi1*P_46 + F_r_star_place*P_50 + F_r_star_r_star*P_16 + F_r_star_rho*P_48 + F_r_star_u*PW_4 + F_r_star_v_star*P_4
        P_4 = FP_0_4
        P_16 = FP_1_4
        P_0 = P_0 + FP_0_4*F_v_star_pi1
        P_1 = P_1 + FP_0_4*F_r_star_pi1
        P_13 = P_13 + FP_1_4*F_r_star_pi1
        PW_5 = P_28 + P_60 + P_59*steer
        FP_0_5 = F_v_star_K*P_38 + F_v_star_eta*P_55 + F_v_star_grip*P_57 + F_v_star_pi1*P_47 + F_v_star_place*P_58 + F_v_star_r_star*P_17 + F_v_star_rho*P_56 + F_v_star_u*PW_5 + F_v_star_v_star*P_5
        FP_1_5 = F_r_star_K*P_38 + F_r_star_eta*P_55 + F_r_star_grip*P_57 + F_r_star_pi1*P_47 + F_r_star_place*P_58 + F_r_star_r_star*P_17 + F_r_star_rho*P_56 + F_r_star_u*PW_5 + F_r_star_v_star*P_5
        P_5 = FP_0_5
        P_17 = FP_1_5
        P_0 = P_0 + FP_0_5*F_v_star_eta
        P_1 = P_1 + FP_0_5*F_r_star_eta
        P_13 = P_13 + FP_1_5*F_r_star_eta
        PW_6 = P_29 + P_67 + P_66*steer
        FP_0_6 = F_v_star_K*P_39 + F_v_star_eta*P_56 + F_v_star_grip*P_64 + F_v_star_pi1*P_48 + F_v_star_place*P_65 + F_v_star_r_star*P_18 + F_v_star_rho*P_63 + F_v_star_u*PW_6 + F_v_star_v_star*P_6
        FP_1_6 = F_r_star_K*P_39 + F_r_star_eta*P_56 + F_r_star_grip*P_64 + F_r_star_pi1*P_48 + F_r_star_place*P_65 + F_r_star_r_star*P_18 + F_r_star_rho*P_63 + F_r_star_u*PW_6 + F_r_star_v_star*P_6
        P_6 = FP_0_6
        P_18 = FP_1_6
        P_0 = P_0 + FP_0_6*F_v_star_rho
        P_1 = P_1 + FP_0_6*F_r_star_rho
        P_13 = P_13 + FP_1_6*F_r_star_rho
        PW_7 = P_30 + P_73 + P_72*steer
        FP_0_7 = F_v_star_K*P_40 + F_v_star_eta*P_57 + F_v_star_grip*P_70 + F_v_star_pi1*P_49 + F_v_star_place*P_71 + F_v_star_r_star*P_19 + F_v_star_rho*P_64 + F_v_star_u*PW_7 + F_v_star_v_star*P_7
        FP_1_7 = F_r_star_K*P_40 + F_r_star_eta*P_57 + F_r_star_grip*P_70 + F_r_star_pi1*P_49 + F_r_star_place*P_71 + F_r_star_r_star*P_19 + F_r_star_rho*P_64 + F_r_star_u*PW_7 + F_r_star_v_star*P_7
        P_7 = FP_0_7
        P_19 = FP_1_7
        P_0 = P_0 + FP_0_7*F_v_star_grip
        P_1 = P_1 + FP_0_7*F_r_star_grip
        P_13 = P_13 + FP_1_7*F_r_star_grip
        PW_8 = P_31 + P_78 + P_77*steer
        FP_0_8 = F_v_star_K*P_41 + F_v_star_eta*P_58 + F_v_star_grip*P_71 + F_v_star_pi1*P_50 + F_v_star_place*P_76 + F_v_star_r_star*P_20 + F_v_star_rho*P_65 + F_v_star_u*PW_8 + F_v_star_v_star*P_8
        FP_1_8 = F_r_star_K*P_41 + F_r_star_eta*P_58 + F_r_star_grip*P_71 + F_r_star_pi1*P_50 + F_r_star_place*P_76 + F_r_star_r_star*P_20 + F_r_star_rho*P_65 + F_r_star_u*PW_8 + F_r_star_v_star*P_8
        P_8 = FP_0_8
        P_20 = FP_1_8
        P_0 = P_0 + FP_0_8*F_v_star_place
        P_1 = P_1 + FP_0_8*F_r_star_place
        P_13 = P_13 + FP_1_8*F_r_star_place
        PW_9 = P_32 + P_82 + P_81*steer
        FP_0_9 = F_v_star_K*P_42 + F_v_star_eta*P_59 + F_v_star_grip*P_72 + F_v_star_pi1*P_51 + F_v_star_place*P_77 + F_v_star_r_star*P_21 + F_v_star_rho*P_66 + F_v_star_u*PW_9 + F_v_star_v_star*P_9
        FP_1_9 = F_r_star_K*P_42 + F_r_star_eta*P_59 + F_r_star_grip*P_72 + F_r_star_pi1*P_51 + F_r_star_place*P_77 + F_r_star_r_star*P_21 + F_r_star_rho*P_66 + F_r_star_u*PW_9 + F_r_star_v_star*P_9
        P_9 = FP_0_9
        P_21 = FP_1_9
        PW_10 = P_33 + P_85 + P_82*steer
        FP_0_10 = F_v_star_K*P_43 + F_v_star_eta*P_60 + F_v_star_grip*P_73 + F_v_star_pi1*P_52 + F_v_star_place*P_78 + F_v_star_r_star*P_22 + F_v_star_rho*P_67 + F_v_star_u*PW_10 + F_v_star_v_star*P_10
        FP_1_10 = F_r_star_K*P_43 + F_r_star_eta*P_60 + F_r_star_grip*P_73 + F_r_star_pi1*P_52 + F_r_star_place*P_78 + F_r_star_r_star*P_22 + F_r_star_rho*P_67 + F_r_star_u*PW_10 + F_r_star_v_star*P_10
        P_10 = FP_0_10
        P_22 = FP_1_10
        PW_11 = P_34 + P_86 + P_83*steer
        FP_0_11 = F_v_star_K*P_44 + F_v_star_eta*P_61 + F_v_star_grip*P_74 + F_v_star_pi1*P_53 + F_v_star_place*P_79 + F_v_star_r_star*P_23 + F_v_star_rho*P_68 + F_v_star_u*PW_11 + F_v_star_v_star*P_11
        FP_1_11 = F_r_star_K*P_44 + F_r_star_eta*P_61 + F_r_star_grip*P_74 + F_r_star_pi1*P_53 + F_r_star_place*P_79 + F_r_star_r_star*P_23 + F_r_star_rho*P_68 + F_r_star_u*PW_11 + F_r_star_v_star*P_11
        P_11 = FP_0_11
        P_23 = FP_1_11
        PW_12 = P_35 + P_87 + P_84*steer
        FP_0_12 = F_v_star_K*P_45 + F_v_star_eta*P_62 + F_v_star_grip*P_75 + F_v_star_pi1*P_54 + F_v_star_place*P_80 + F_v_star_r_star*P_24 + F_v_star_rho*P_69 + F_v_star_u*PW_12 + F_v_star_v_star*P_12
        FP_1_12 = F_r_star_K*P_45 + F_r_star_eta*P_62 + F_r_star_grip*P_75 + F_r_star_pi1*P_54 + F_r_star_place*P_80 + F_r_star_r_star*P_24 + F_r_star_rho*P_69 + F_r_star_u*PW_12 + F_r_star_v_star*P_12
        P_12 = FP_0_12
        P_24 = FP_1_12
        WPF_0 = FP_0_10 + FP_0_2 + FP_0_9*steer
        WPF_1 = FP_1_10 + FP_1_2 + FP_1_9*steer
        P_0 = P_0 + F_v_star_u*WPF_0
        P_1 = P_1 + F_r_star_u*WPF_0
        P_13 = P_13 + F_r_star_u*WPF_1
        P_25 = P_25*(keep_w*keep_w) + disturbance_scale*w_nominal*(1.0 - (keep_w*keep_w))
        P_26 = P_26*keep_w
        P_27 = P_27*keep_w
        P_28 = P_28*keep_w
        P_29 = P_29*keep_w
        P_30 = P_30*keep_w
        P_31 = P_31*keep_w
        P_32 = P_32*keep_w
        P_33 = P_33*keep_w
        P_34 = P_34*keep_w
        P_35 = P_35*keep_w
        P_36 = P_36 + dt*(diffusion + jump*jump_drift)
        P_88 = P_88 + bias_drift*dt
        P_90 = P_90 + ay_bias_drift*dt
        disturbance = disturbance*keep_w
        v_star = d_v_star + v_star
        r_star = d_r_star + r_star
        follow = (1.0 if (1.0) < (companion_rate*dt) else companion_rate*dt)
        input_offset_plain = input_offset_plain + (input_offset - input_offset_plain)*(1.0 if (1.0) < (dt*offset_rate) else dt*offset_rate)
        v_star_plain = d_v_star_plain + v_star_plain + follow*(v_star - d_v_star_plain - v_star_plain)
        r_star_plain = d_r_star_plain + r_star_plain + follow*(r_star - d_r_star_plain - r_star_plain)
        response = output_scale*r_star  # output of the model
        predicted = output_bias + response
        output_rate = d_r_star*inv_dt*output_scale
        activity = activity + ((response*response) - activity)*(1.0 if (1.0) < (activity_rate*dt) else activity_rate*dt)
        noise = noise_scale*(noise_variance + (output_rate*output_rate)*(timing_error*timing_error) + activity*(structure_share*structure_share)*(1.0 if (1.0) > (2.0*inv_dt*structure_time) else 2.0*inv_dt*structure_time))  # variance of the measurement
        validity_now = inv_L*r_star*(at_U*at_U)  # lateral acceleration
        validity_then = validity*(1.0 - (1.0 if (1.0) < (dt*validity_rate) else dt*validity_rate))
        validity_square = (validity_now*validity_now)
        validity = (validity_square if (validity_square) > (validity_then) else validity_then)
        if usable > 0.5:  # measurement
            c_1 = P_23 + P_13*output_scale
            c_3 = P_44 + P_15*output_scale
            c_11 = P_88 + P_23*output_scale
            innovation = measured - predicted
            innovation_variance = c_11 + noise + c_1*output_scale
            inv_spread = (1.0/innovation_variance)
            nis = inv_spread*(innovation*innovation)  # normalised innovation squared
            if nis > outlier_ratio:  # an outlier counts for less
                inv_spread = inv_spread*outlier_ratio/nis
            inv_P = (1.0/P_36)
            sensitivity = c_3*inv_P  # of the output to ln K
            excitation = excitation + ((sensitivity*sensitivity) - excitation)*(1.0 if (1.0) < (dt*excitation_rate) else dt*excitation_rate)
            excited = (1.0 if excitation > excitation_ratio*noise else 0.0)
            linear = (1.0 if validity < (validity_limit*validity_limit) else 0.0)  # 1 in the model's linear range
            odd = (9.0 if (9.0) < (nis) else nis) - 1.0  # by how much it is not as expected
            surprise = surprise + (1.0 + linear*odd - surprise)*(1.0 if (1.0) < (dt*surprise_rate) else dt*surprise_rate)  # recent mean of the normalised innovation squared
            learn_beyond = excited*inv_spread
            untaught = dt + untaught
            learn = (excited*inv_spread if (beyond_time <= untaught) or (linear > 0.5) else 0.0)  # its error there lasts
            if learn > 0.0:
                untaught = 0.0
            heard = heard*(1.0 - (1.0 if (1.0) < (dt*heard_rate) else dt*heard_rate)) + inv_spread*(sensitivity*sensitivity)  # information of late
            above = surprise - 1.0
            restlessness = restlessness + ((above*above) - restlessness)*(1.0 if (1.0) < (dt*noise_adapt) else dt*noise_adapt)
            rise = (surprise - surprise_limit if (above*above) > jump_ratio*restlessness else 0.0)
            jump = (0.0 if (0.0) > (rise) else rise)
            learn_slow = (learn if jump <= 0.0 else 0.0)  # a jump is not blamed on what cannot jump
            unlearnt = dt + unlearnt
            learn_seldom = (learn_slow if seldom <= unlearnt else 0.0)  # the next sample tells little that this one does not
            if learn_seldom > 0.0:
                unlearnt = 0.0
            gain_3 = c_3*learn
            gained = c_3*gain_3*inv_P  # share of the variance removed
            information = information + gained*inv_P*(1.0 + gained)  # 1/variance gained
            move = move + gain_3*innovation
            c_0 = P_11 + P_1*output_scale
            c_2 = P_34 + P_14*output_scale
            c_4 = P_53 + P_16*output_scale
            c_5 = P_61 + P_17*output_scale
            c_6 = P_68 + P_18*output_scale
            c_7 = P_74 + P_19*output_scale
            c_8 = P_79 + P_20*output_scale
            c_9 = P_83 + P_21*output_scale
            c_10 = P_86 + P_22*output_scale
            c_12 = P_89 + P_24*output_scale
            gain_0 = c_0*inv_spread
            gain_1 = c_1*inv_spread
            gain_2 = c_2*inv_spread
            gain_4 = c_4*learn_seldom
            gain_5 = c_5*learn_slow
            gain_6 = c_6*learn_slow
            gain_7 = c_7*learn_beyond
            gain_8 = c_8*learn_slow
            gain_9 = c_9*learn_slow
            gain_10 = c_10*inv_spread
            gain_11 = c_11*inv_spread
            gain_12 = c_12*inv_spread
            P_0 = P_0 - c_0*gain_0
            P_1 = P_1 - c_1*gain_0
            P_2 = P_2 - c_2*gain_0
            P_3 = P_3 - c_3*gain_0
            P_4 = P_4 - c_4*gain_0
            P_5 = P_5 - c_5*gain_0
            P_6 = P_6 - c_6*gain_0
            P_7 = P_7 - c_7*gain_0
            P_8 = P_8 - c_8*gain_0
            P_9 = P_9 - c_9*gain_0
            P_10 = P_10 - c_10*gain_0
            P_11 = P_11 - c_11*gain_0
            P_12 = P_12 - c_12*gain_0
            P_13 = P_13 - c_1*gain_1
            P_14 = P_14 - c_2*gain_1
            P_15 = P_15 - c_3*gain_1
            P_16 = P_16 - c_4*gain_1
            P_17 = P_17 - c_5*gain_1
            P_18 = P_18 - c_6*gain_1
            P_19 = P_19 - c_7*gain_1
            P_20 = P_20 - c_8*gain_1
            P_21 = P_21 - c_9*gain_1
            P_22 = P_22 - c_10*gain_1
            P_23 = P_23 - c_11*gain_1
            P_24 = P_24 - c_12*gain_1
            P_25 = P_25 - c_2*gain_2
            P_26 = P_26 - c_3*gain_2
            P_27 = P_27 - c_4*gain_2
            P_28 = P_28 - c_5*gain_2
            P_29 = P_29 - c_6*gain_2
            P_30 = P_30 - c_7*gain_2
            P_31 = P_31 - c_8*gain_2
            P_32 = P_32 - c_9*gain_2
            P_33 = P_33 - c_10*gain_2
            P_34 = P_34 - c_11*gain_2
            P_35 = P_35 - c_12*gain_2
            P_36 = P_36 - c_3*gain_3
            P_37 = P_37 - c_4*gain_3
            P_38 = P_38 - c_5*gain_3
            P_39 = P_39 - c_6*gain_3
            P_40 = P_40 - c_3*gain_7
            P_41 = P_41 - c_8*gain_3
            P_42 = P_42 - c_9*gain_3
            P_43 = P_43 - c_3*gain_10
            P_44 = P_44 - c_3*gain_11
            P_45 = P_45 - c_3*gain_12
            P_46 = P_46 - c_4*gain_4
            P_47 = P_47 - c_4*gain_5
            P_48 = P_48 - c_4*gain_6
            P_49 = P_49 - c_4*gain_7
            P_50 = P_50 - c_4*gain_8
            P_51 = P_51 - c_4*gain_9
            P_52 = P_52 - c_4*gain_10
            P_53 = P_53 - c_4*gain_11
            P_54 = P_54 - c_4*gain_12
            P_55 = P_55 - c_5*gain_5
            P_56 = P_56 - c_6*gain_5
            P_57 = P_57 - c_5*gain_7
            P_58 = P_58 - c_8*gain_5
            P_59 = P_59 - c_9*gain_5
            P_60 = P_60 - c_5*gain_10
            P_61 = P_61 - c_5*gain_11
            P_62 = P_62 - c_5*gain_12
            P_63 = P_63 - c_6*gain_6
            P_64 = P_64 - c_6*gain_7
            P_65 = P_65 - c_8*gain_6
            P_66 = P_66 - c_9*gain_6
            P_67 = P_67 - c_6*gain_10
            P_68 = P_68 - c_6*gain_11
            P_69 = P_69 - c_6*gain_12
            P_70 = P_70 - c_7*gain_7
            P_71 = P_71 - c_8*gain_7
            P_72 = P_72 - c_9*gain_7
            P_73 = P_73 - c_7*gain_10
            P_74 = P_74 - c_7*gain_11
            P_75 = P_75 - c_7*gain_12
            P_76 = P_76 - c_8*gain_8
            P_77 = P_77 - c_9*gain_8
            P_78 = P_78 - c_8*gain_10
            P_79 = P_79 - c_8*gain_11
            P_80 = P_80 - c_8*gain_12
            P_81 = P_81 - c_9*gain_9
            P_82 = P_82 - c_9*gain_10
            P_83 = P_83 - c_9*gain_11
            P_84 = P_84 - c_9*gain_12
            P_85 = P_85 - c_10*gain_10
            P_86 = P_86 - c_11*gain_10
            P_87 = P_87 - c_12*gain_10
            P_88 = P_88 - c_11*gain_11
            P_89 = P_89 - c_12*gain_11
            P_90 = P_90 - c_12*gain_12
            v_star = v_star + gain_0*innovation
            r_star = r_star + gain_1*innovation
            disturbance = disturbance + gain_2*innovation
            pi1 = pi1 + gain_4*innovation
            move_eta = gain_5*innovation
            above_move_eta = ((-1.0) if ((-1.0)) > (move_eta) else move_eta)
            bounded_move_eta = (1.0 if (1.0) < (above_move_eta) else above_move_eta)
            eta = eta*(1.0 + bounded_move_eta*(1.0 + bounded_move_eta*(0.5 + 0.16666666666666666*bounded_move_eta)))
            move_rho = gain_6*innovation
            above_move_rho = ((-1.0) if ((-1.0)) > (move_rho) else move_rho)
            bounded_move_rho = (1.0 if (1.0) < (above_move_rho) else above_move_rho)
            rho = rho*(1.0 + bounded_move_rho*(1.0 + bounded_move_rho*(0.5 + 0.16666666666666666*bounded_move_rho)))
            move_grip = gain_7*innovation
            above_move_grip = ((-1.0) if ((-1.0)) > (move_grip) else move_grip)
            bounded_move_grip = (1.0 if (1.0) < (above_move_grip) else above_move_grip)
            grip = grip*(1.0 + bounded_move_grip*(1.0 + bounded_move_grip*(0.5 + 0.16666666666666666*bounded_move_grip)))
            place = place + gain_8*innovation
            move_input_scale = gain_9*innovation
            above_move_input_scale = ((-1.0) if ((-1.0)) > (move_input_scale) else move_input_scale)
            bounded_move_input_scale = (1.0 if (1.0) < (above_move_input_scale) else above_move_input_scale)
            input_scale = input_scale*(1.0 + bounded_move_input_scale*(1.0 + bounded_move_input_scale*(0.5 + 0.16666666666666666*bounded_move_input_scale)))
            input_offset = input_offset + gain_10*innovation
            output_bias = output_bias + gain_11*innovation
            ay_bias = ay_bias + gain_12*innovation
            settling = (noise_adapt if (noise_adapt) > (settling - dt*(settling*settling)) else settling - dt*(settling*settling))  # 1/time at first
            noise_change = odd*(0.05 if (0.05) < (dt*settling) else dt*settling)
            noise_scale = noise_scale*(1.0 + noise_change*(1.0 + noise_change*(0.5 + 0.16666666666666666*noise_change)))
            noise_scale = (noise_scale if (noise_scale) > (noise_scale_low) else noise_scale_low)
            noise_scale = (noise_scale if (noise_scale) < (noise_scale_high) else noise_scale_high)
            expected = disturbance_scale*w_nominal  # disturbance variance expected
            seen = (9.0*expected if (9.0*expected) < (P_25 + (disturbance*disturbance)) else P_25 + (disturbance*disturbance))  # and seen
            unseen = (expected*observed_least if (expected*observed_least) > (expected - P_25) else expected - P_25)
            disturbance_scale = disturbance_scale + disturbance_scale*(seen - expected)*(1.0 if (1.0) < (disturbance_adapt*dt) else disturbance_adapt*dt)/unseen
            disturbance_scale = (disturbance_scale if (disturbance_scale) > (disturbance_scale_low) else disturbance_scale_low)
            disturbance_scale = (disturbance_scale if (disturbance_scale) < (disturbance_scale_high) else disturbance_scale_high)
            if (excited < 0.5) and (status < 0.5):
                status = 1.0
            if (status < 1.5) and (validity > (validity_limit*validity_limit)):
                status = 2.0
            if abs(ay_measured) < ay_limit:  # ay is measured too
                ay_scale = inv_L*(at_U*at_U)  # ay = scale x dimensionless
                ay_u = disturbance + input_offset + input_scale*u_now  # effective input at the end [-]
                ay_u_plain = input_scale*u_now
                ay_s0 = v_star + pi1*r_star
                ay_s1 = ay_s0 - ay_u
                ay_s2 = (1.0/(pi1 - 1.0))
                ay_s3 = K*inv_L
                ay_s4 = ay_s3/grip
                ay_s5 = ay_s2*ay_s4
                ay_s6 = ay_s1*ay_s5
                ay_s7 = ((-ay_s6) if ((-ay_s6)) > (ay_s6) else ay_s6)
                ay_s8 = 10.0 + ay_s7*(10.0 + 7.0*ay_s7)
                ay_s9 = 10.0 + ay_s7*ay_s8
                ay_s10 = (1.0/ay_s9)
                ay_s11 = ay_s1*ay_s10*ay_s8
                ay_s12 = eta*(ay_s0 - r_star)
                ay_s13 = ay_s12*ay_s5
                ay_s14 = ((-ay_s13) if ((-ay_s13)) > (ay_s13) else ay_s13)
                ay_s15 = 10.0 + ay_s14*(10.0 + 7.0*ay_s14)
                ay_s16 = 10.0 + ay_s14*ay_s15
                ay_s17 = ay_s12*ay_s15/ay_s16
                ay_s18 = (1.0/rho)
                ay_s19 = pi1 - place
                ay_s20 = ay_s18*ay_s19
                ay_s21 = L*ay_s3*ay_scale*(inv_U*inv_U)
                ay_s22 = ay_s2*ay_s21
                ay_s23 = 10.0 + ay_s7*(20.0 + 21.0*ay_s7)
                ay_s24 = (1.0/(ay_s9*ay_s9))
                ay_s25 = ay_s23*ay_s24
                ay_s26 = eta*(10.0 + ay_s14*(20.0 + 21.0*ay_s14))/((ay_s16*ay_s16))
                ay_s27 = 10.0*ay_s22
                ay_s28 = ay_s26 - ay_s2*ay_s23*ay_s24*pi1
                ay_s29 = ay_s2*ay_s25
                ay_s30 = 10.0*ay_s21
                ay_s31 = v_star_plain + pi1*r_star_plain
                ay_s32 = ay_s31 - ay_u_plain
                ay_s33 = ay_s2*ay_s32
                ay_s34 = ay_s33*ay_s4
                ay_s35 = ((-ay_s34) if ((-ay_s34)) > (ay_s34) else ay_s34)
                ay_s36 = 10.0 + ay_s35*(10.0 + 7.0*ay_s35)
                ay_s37 = 10.0 + ay_s35*ay_s36
                ay_s38 = (1.0/(ay_s37*ay_s37))
                ay_s39 = 10.0 + ay_s35*(20.0 + 21.0*ay_s35)
                ay_s40 = ay_s38*ay_s39
                ay_s41 = ay_s32*ay_s40
                ay_s42 = ay_s41*pi1
                ay_s43 = ay_s31 - r_star_plain
                ay_s44 = ay_s43*eta
                ay_s45 = ay_s2*ay_s43
                ay_s46 = ay_s4*ay_s45*eta
                ay_s47 = ((-ay_s46) if ((-ay_s46)) > (ay_s46) else ay_s46)
                ay_s48 = 10.0 + ay_s47*(10.0 + 7.0*ay_s47)
                ay_s49 = 10.0 + ay_s47*ay_s48
                ay_s50 = (10.0 + ay_s47*(20.0 + 21.0*ay_s47))/((ay_s49*ay_s49))
                ay_s51 = ay_s44*ay_s50
                ay_s52 = ay_s51*pi1
                ay_s53 = ay_s51 - ay_s32*ay_s38*ay_s39
                ay_s54 = ay_s32*ay_s36/ay_s37
                ay_s55 = ay_s44*ay_s48/ay_s49
                ay_s56 = ay_s55 - ay_s54
                ay_s57 = (-ay_s18*ay_s56)
                ay_s58 = r_star_plain - ay_s33
                ay_s59 = ay_s50*eta
                ay_s60 = ay_s59*(r_star_plain - ay_s45)
                ay_s61 = 10.0*ay_s20
                ay_s62 = 10.0*ay_s40*ay_s58
                ay_s63 = ay_s19*ay_s57
                ay_response = ay_s22*(ay_s11 + ay_s17*pi1 + ay_s20*(ay_s1*ay_s10*ay_s8 - ay_s17) - ay_s11*pi1)
                ay_by_v_star = ay_s27*(ay_s25 + ay_s20*(ay_s23*ay_s24 - ay_s26) + ay_s26*pi1 - ay_s25*pi1)
                ay_by_r_star = ay_s30*((-pi1*((-ay_s28) - ay_s29)) - ay_s18*ay_s19*ay_s28)
                ay_by_K = ay_s27*(ay_s41 + ay_s52 - ay_s42 - ay_s20*ay_s53)
                ay_by_pi1 = ay_s22*(ay_s56 + ay_s57 + ay_s62 + 10.0*ay_s60*pi1 + ay_s61*(ay_s38*ay_s39*ay_s58 - ay_s60) - ay_s62*pi1)
                ay_by_eta = ay_s30*ay_s45*ay_s59*(pi1 - ay_s20)
                ay_by_rho = (-ay_s22*ay_s63)
                ay_by_grip = ay_s22*(10.0*ay_s42 + ay_s54 + ay_s63 + ay_s53*ay_s61 + ay_s55*pi1 - 10.0*ay_s41 - 10.0*ay_s52 - ay_s54*pi1)
                ay_by_place = (-ay_s22*ay_s57)
                ay_by_u = (-ay_s29*ay_s30*(1.0 + ay_s20 - pi1))
                ay_activity = ay_activity + ((ay_response*ay_response) - ay_activity)*(1.0 if (1.0) < (activity_rate*dt) else activity_rate*dt)
                ay_noise = ay_noise_scale*(ay_variance + ay_activity*(ay_share*ay_share))*(1.0 if (1.0) > (2.0*ay_time*inv_dt) else 2.0*ay_time*inv_dt)  # variance of ay
                ay_c_0 = (P_12 + P_0*ay_by_v_star + P_1*ay_by_r_star + P_10*ay_by_u + P_2*ay_by_u + P_3*ay_by_K) + (P_4*ay_by_pi1 + P_5*ay_by_eta + P_6*ay_by_rho + P_7*ay_by_grip + P_8*ay_by_place + P_9*ay_by_u*input_scale*u_now)
                ay_c_1 = (P_24 + P_1*ay_by_v_star + P_13*ay_by_r_star + P_14*ay_by_u + P_15*ay_by_K + P_16*ay_by_pi1) + (P_17*ay_by_eta + P_18*ay_by_rho + P_19*ay_by_grip + P_20*ay_by_place + P_22*ay_by_u + P_21*ay_by_u*input_scale*u_now)
                ay_c_2 = (P_35 + P_14*ay_by_r_star + P_2*ay_by_v_star + P_25*ay_by_u + P_26*ay_by_K + P_27*ay_by_pi1) + (P_28*ay_by_eta + P_29*ay_by_rho + P_30*ay_by_grip + P_31*ay_by_place + P_33*ay_by_u + P_32*ay_by_u*input_scale*u_now)
                ay_c_3 = (P_45 + P_15*ay_by_r_star + P_26*ay_by_u + P_3*ay_by_v_star + P_36*ay_by_K + P_37*ay_by_pi1) + (P_38*ay_by_eta + P_39*ay_by_rho + P_40*ay_by_grip + P_41*ay_by_place + P_43*ay_by_u + P_42*ay_by_u*input_scale*u_now)
                ay_c_4 = (P_54 + P_16*ay_by_r_star + P_27*ay_by_u + P_37*ay_by_K + P_4*ay_by_v_star + P_46*ay_by_pi1) + (P_47*ay_by_eta + P_48*ay_by_rho + P_49*ay_by_grip + P_50*ay_by_place + P_52*ay_by_u + P_51*ay_by_u*input_scale*u_now)
                ay_c_5 = (P_62 + P_17*ay_by_r_star + P_28*ay_by_u + P_38*ay_by_K + P_47*ay_by_pi1 + P_5*ay_by_v_star) + (P_55*ay_by_eta + P_56*ay_by_rho + P_57*ay_by_grip + P_58*ay_by_place + P_60*ay_by_u + P_59*ay_by_u*input_scale*u_now)
                ay_c_6 = (P_69 + P_18*ay_by_r_star + P_29*ay_by_u + P_39*ay_by_K + P_48*ay_by_pi1 + P_56*ay_by_eta) + (P_6*ay_by_v_star + P_63*ay_by_rho + P_64*ay_by_grip + P_65*ay_by_place + P_67*ay_by_u + P_66*ay_by_u*input_scale*u_now)
                ay_c_7 = (P_75 + P_19*ay_by_r_star + P_30*ay_by_u + P_40*ay_by_K + P_49*ay_by_pi1 + P_57*ay_by_eta) + (P_64*ay_by_rho + P_7*ay_by_v_star + P_70*ay_by_grip + P_71*ay_by_place + P_73*ay_by_u + P_72*ay_by_u*input_scale*u_now)
                ay_c_8 = (P_80 + P_20*ay_by_r_star + P_31*ay_by_u + P_41*ay_by_K + P_50*ay_by_pi1 + P_58*ay_by_eta) + (P_65*ay_by_rho + P_71*ay_by_grip + P_76*ay_by_place + P_78*ay_by_u + P_8*ay_by_v_star + P_77*ay_by_u*input_scale*u_now)
                ay_c_9 = (P_84 + P_21*ay_by_r_star + P_32*ay_by_u + P_42*ay_by_K + P_51*ay_by_pi1 + P_59*ay_by_eta) + (P_66*ay_by_rho + P_72*ay_by_grip + P_77*ay_by_place + P_82*ay_by_u + P_9*ay_by_v_star + P_81*ay_by_u*input_scale*u_now)
                ay_c_10 = (P_87 + P_10*ay_by_v_star + P_22*ay_by_r_star + P_33*ay_by_u + P_43*ay_by_K + P_52*ay_by_pi1) + (P_60*ay_by_eta + P_67*ay_by_rho + P_73*ay_by_grip + P_78*ay_by_place + P_85*ay_by_u + P_82*ay_by_u*input_scale*u_now)
                ay_c_12 = (P_90 + P_12*ay_by_v_star + P_24*ay_by_r_star + P_35*ay_by_u + P_45*ay_by_K + P_54*ay_by_pi1) + (P_62*ay_by_eta + P_69*ay_by_rho + P_75*ay_by_grip + P_80*ay_by_place + P_87*ay_by_u + P_84*ay_by_u*input_scale*u_now)
                ay_innovation = ay_measured - ay_bias - ay_response - ay_by_K*move
                ay_inv_spread = (1.0/((ay_c_12 + ay_noise + ay_by_K*ay_c_3 + ay_by_eta*ay_c_5 + ay_by_grip*ay_c_7 + ay_by_pi1*ay_c_4) + (ay_by_place*ay_c_8 + ay_by_r_star*ay_c_1 + ay_by_rho*ay_c_6 + ay_by_u*ay_c_10 + ay_by_u*ay_c_2 + ay_by_v_star*ay_c_0 + ay_by_u*ay_c_9*input_scale*u_now)))
                ay_nis = ay_inv_spread*(ay_innovation*ay_innovation)  # normalised innovation squared
                if ay_nis > outlier_ratio:  # an outlier counts for less
                    ay_inv_spread = ay_inv_spread*outlier_ratio/ay_nis
                ay_learn_beyond = (ay_inv_spread if learn_beyond > 0.0 else 0.0)  # where the first may learn
                ay_learn = (ay_inv_spread if learn > 0.0 else 0.0)  # where the first may learn
                ay_learn_slow = (ay_inv_spread if learn_slow > 0.0 else 0.0)  # where the first may learn
                ay_learn_seldom = (ay_inv_spread if learn_seldom > 0.0 else 0.0)  # where the first may learn
                ay_gain_3 = ay_c_3*ay_learn
                ay_inv_P = (1.0/P_36)
                ay_gained = ay_c_3*ay_gain_3*ay_inv_P  # share of the variance removed
                information = information + ay_gained*ay_inv_P*(1.0 + ay_gained)
                move = move + ay_gain_3*ay_innovation
                ay_c_11 = (P_89 + P_11*ay_by_v_star + P_23*ay_by_r_star + P_34*ay_by_u + P_44*ay_by_K + P_53*ay_by_pi1) + (P_61*ay_by_eta + P_68*ay_by_rho + P_74*ay_by_grip + P_79*ay_by_place + P_86*ay_by_u + P_83*ay_by_u*input_scale*u_now)
                ay_gain_0 = ay_c_0*ay_inv_spread
                ay_gain_1 = ay_c_1*ay_inv_spread
                ay_gain_2 = ay_c_2*ay_inv_spread
                ay_gain_4 = ay_c_4*ay_learn_seldom
                ay_gain_5 = ay_c_5*ay_learn_slow
                ay_gain_6 = ay_c_6*ay_learn_slow
                ay_gain_7 = ay_c_7*ay_learn_beyond
                ay_gain_8 = ay_c_8*ay_learn_slow
                ay_gain_9 = ay_c_9*ay_learn_slow
                ay_gain_10 = ay_c_10*ay_inv_spread
                ay_gain_11 = ay_c_11*ay_inv_spread
                ay_gain_12 = ay_c_12*ay_inv_spread
                P_0 = P_0 - ay_c_0*ay_gain_0
                P_1 = P_1 - ay_c_1*ay_gain_0
                P_2 = P_2 - ay_c_2*ay_gain_0
                P_3 = P_3 - ay_c_3*ay_gain_0
                P_4 = P_4 - ay_c_4*ay_gain_0
                P_5 = P_5 - ay_c_5*ay_gain_0
                P_6 = P_6 - ay_c_6*ay_gain_0
                P_7 = P_7 - ay_c_7*ay_gain_0
                P_8 = P_8 - ay_c_8*ay_gain_0
                P_9 = P_9 - ay_c_9*ay_gain_0
                P_10 = P_10 - ay_c_10*ay_gain_0
                P_11 = P_11 - ay_c_11*ay_gain_0
                P_12 = P_12 - ay_c_12*ay_gain_0
                P_13 = P_13 - ay_c_1*ay_gain_1
                P_14 = P_14 - ay_c_2*ay_gain_1
                P_15 = P_15 - ay_c_3*ay_gain_1
                P_16 = P_16 - ay_c_4*ay_gain_1
                P_17 = P_17 - ay_c_5*ay_gain_1
                P_18 = P_18 - ay_c_6*ay_gain_1
                P_19 = P_19 - ay_c_7*ay_gain_1
                P_20 = P_20 - ay_c_8*ay_gain_1
                P_21 = P_21 - ay_c_9*ay_gain_1
                P_22 = P_22 - ay_c_10*ay_gain_1
                P_23 = P_23 - ay_c_11*ay_gain_1
                P_24 = P_24 - ay_c_12*ay_gain_1
                P_25 = P_25 - ay_c_2*ay_gain_2
                P_26 = P_26 - ay_c_3*ay_gain_2
                P_27 = P_27 - ay_c_4*ay_gain_2
                P_28 = P_28 - ay_c_5*ay_gain_2
                P_29 = P_29 - ay_c_6*ay_gain_2
                P_30 = P_30 - ay_c_7*ay_gain_2
                P_31 = P_31 - ay_c_8*ay_gain_2
                P_32 = P_32 - ay_c_9*ay_gain_2
                P_33 = P_33 - ay_c_10*ay_gain_2
                P_34 = P_34 - ay_c_11*ay_gain_2
                P_35 = P_35 - ay_c_12*ay_gain_2
                P_36 = P_36 - ay_c_3*ay_gain_3
                P_37 = P_37 - ay_c_4*ay_gain_3
                P_38 = P_38 - ay_c_5*ay_gain_3
                P_39 = P_39 - ay_c_6*ay_gain_3
                P_40 = P_40 - ay_c_3*ay_gain_7
                P_41 = P_41 - ay_c_8*ay_gain_3
                P_42 = P_42 - ay_c_9*ay_gain_3
                P_43 = P_43 - ay_c_3*ay_gain_10
                P_44 = P_44 - ay_c_3*ay_gain_11
                P_45 = P_45 - ay_c_3*ay_gain_12
                P_46 = P_46 - ay_c_4*ay_gain_4
                P_47 = P_47 - ay_c_4*ay_gain_5
                P_48 = P_48 - ay_c_4*ay_gain_6
                P_49 = P_49 - ay_c_4*ay_gain_7
                P_50 = P_50 - ay_c_4*ay_gain_8
                P_51 = P_51 - ay_c_4*ay_gain_9
                P_52 = P_52 - ay_c_4*ay_gain_10
                P_53 = P_53 - ay_c_4*ay_gain_11
                P_54 = P_54 - ay_c_4*ay_gain_12
                P_55 = P_55 - ay_c_5*ay_gain_5
                P_56 = P_56 - ay_c_6*ay_gain_5
                P_57 = P_57 - ay_c_5*ay_gain_7
                P_58 = P_58 - ay_c_8*ay_gain_5
                P_59 = P_59 - ay_c_9*ay_gain_5
                P_60 = P_60 - ay_c_5*ay_gain_10
                P_61 = P_61 - ay_c_5*ay_gain_11
                P_62 = P_62 - ay_c_5*ay_gain_12
                P_63 = P_63 - ay_c_6*ay_gain_6
                P_64 = P_64 - ay_c_6*ay_gain_7
                P_65 = P_65 - ay_c_8*ay_gain_6
                P_66 = P_66 - ay_c_9*ay_gain_6
                P_67 = P_67 - ay_c_6*ay_gain_10
                P_68 = P_68 - ay_c_6*ay_gain_11
                P_69 = P_69 - ay_c_6*ay_gain_12
                P_70 = P_70 - ay_c_7*ay_gain_7
                P_71 = P_71 - ay_c_8*ay_gain_7
                P_72 = P_72 - ay_c_9*ay_gain_7
                P_73 = P_73 - ay_c_7*ay_gain_10
                P_74 = P_74 - ay_c_7*ay_gain_11
                P_75 = P_75 - ay_c_7*ay_gain_12
                P_76 = P_76 - ay_c_8*ay_gain_8
                P_77 = P_77 - ay_c_9*ay_gain_8
                P_78 = P_78 - ay_c_8*ay_gain_10
                P_79 = P_79 - ay_c_8*ay_gain_11
                P_80 = P_80 - ay_c_8*ay_gain_12
                P_81 = P_81 - ay_c_9*ay_gain_9
                P_82 = P_82 - ay_c_9*ay_gain_10
                P_83 = P_83 - ay_c_9*ay_gain_11
                P_84 = P_84 - ay_c_9*ay_gain_12
                P_85 = P_85 - ay_c_10*ay_gain_10
                P_86 = P_86 - ay_c_11*ay_gain_10
                P_87 = P_87 - ay_c_12*ay_gain_10
                P_88 = P_88 - ay_c_11*ay_gain_11
                P_89 = P_89 - ay_c_12*ay_gain_11
                P_90 = P_90 - ay_c_12*ay_gain_12
                v_star = v_star + ay_gain_0*ay_innovation
                r_star = r_star + ay_gain_1*ay_innovation
                disturbance = disturbance + ay_gain_2*ay_innovation
                pi1 = pi1 + ay_gain_4*ay_innovation
                ay_move_eta = ay_gain_5*ay_innovation
                above_ay_move_eta = ((-1.0) if ((-1.0)) > (ay_move_eta) else ay_move_eta)
                bounded_ay_move_eta = (1.0 if (1.0) < (above_ay_move_eta) else above_ay_move_eta)
                eta = eta*(1.0 + bounded_ay_move_eta*(1.0 + bounded_ay_move_eta*(0.5 + 0.16666666666666666*bounded_ay_move_eta)))
                ay_move_rho = ay_gain_6*ay_innovation
                above_ay_move_rho = ((-1.0) if ((-1.0)) > (ay_move_rho) else ay_move_rho)
                bounded_ay_move_rho = (1.0 if (1.0) < (above_ay_move_rho) else above_ay_move_rho)
                rho = rho*(1.0 + bounded_ay_move_rho*(1.0 + bounded_ay_move_rho*(0.5 + 0.16666666666666666*bounded_ay_move_rho)))
                ay_move_grip = ay_gain_7*ay_innovation
                above_ay_move_grip = ((-1.0) if ((-1.0)) > (ay_move_grip) else ay_move_grip)
                bounded_ay_move_grip = (1.0 if (1.0) < (above_ay_move_grip) else above_ay_move_grip)
                grip = grip*(1.0 + bounded_ay_move_grip*(1.0 + bounded_ay_move_grip*(0.5 + 0.16666666666666666*bounded_ay_move_grip)))
                place = place + ay_gain_8*ay_innovation
                ay_move_input_scale = ay_gain_9*ay_innovation
                above_ay_move_input_scale = ((-1.0) if ((-1.0)) > (ay_move_input_scale) else ay_move_input_scale)
                bounded_ay_move_input_scale = (1.0 if (1.0) < (above_ay_move_input_scale) else above_ay_move_input_scale)
                input_scale = input_scale*(1.0 + bounded_ay_move_input_scale*(1.0 + bounded_ay_move_input_scale*(0.5 + 0.16666666666666666*bounded_ay_move_input_scale)))
                input_offset = input_offset + ay_gain_10*ay_innovation
                output_bias = output_bias + ay_gain_11*ay_innovation
                ay_bias = ay_bias + ay_gain_12*ay_innovation
                ay_noise_change = ((9.0 if (9.0) < (ay_nis) else ay_nis) - 1.0)*(0.05 if (0.05) < (dt*settling) else dt*settling)
                ay_noise_scale = ay_noise_scale*(1.0 + ay_noise_change*(1.0 + ay_noise_change*(0.5 + 0.16666666666666666*ay_noise_change)))
                ay_noise_scale = (ay_noise_scale if (ay_noise_scale) > (ay_noise_scale_low) else ay_noise_scale_low)
                ay_noise_scale = (ay_noise_scale if (ay_noise_scale) < (ay_noise_scale_high) else ay_noise_scale_high)
        above_move = ((-1.0) if ((-1.0)) > (move) else move)
        bounded_move = (1.0 if (1.0) < (above_move) else above_move)
        K = K*(1.0 + bounded_move*(1.0 + bounded_move*(0.5 + 0.16666666666666666*bounded_move)))
        if (K < K_low) or (K > K_high) or (eta < eta_low) or (eta > eta_high) or (grip < grip_low) or (grip > grip_high) or (input_scale < input_scale_low) or (input_scale > input_scale_high) or (pi1 < pi1_low) or (pi1 > pi1_high) or (place < place_low) or (place > place_high) or (rho < rho_low) or (rho > rho_high):  # prior +- its allowed range
            K = (K_high if (K_high) < ((K if (K) > (K_low) else K_low)) else (K if (K) > (K_low) else K_low))
            pi1 = (pi1_high if (pi1_high) < ((pi1 if (pi1) > (pi1_low) else pi1_low)) else (pi1 if (pi1) > (pi1_low) else pi1_low))
            eta = (eta_high if (eta_high) < ((eta if (eta) > (eta_low) else eta_low)) else (eta if (eta) > (eta_low) else eta_low))
            rho = (rho_high if (rho_high) < ((rho if (rho) > (rho_low) else rho_low)) else (rho if (rho) > (rho_low) else rho_low))
            grip = (grip_high if (grip_high) < ((grip if (grip) > (grip_low) else grip_low)) else (grip if (grip) > (grip_low) else grip_low))
            place = (place_high if (place_high) < ((place if (place) > (place_low) else place_low)) else (place if (place) > (place_low) else place_low))
            input_scale = (input_scale_high if (input_scale_high) < ((input_scale if (input_scale) > (input_scale_low) else input_scale_low)) else (input_scale if (input_scale) > (input_scale_low) else input_scale_low))
            if usable > 0.5:
                status = 3.0
        noise_now = noise
        disturbance_now = disturbance_scale*w_nominal
        last_input = u_now
        last_U = U_now
        if usable > 0.5:
            age = 0.0
            started = 1.0
    else:
        status = 7.0
        age = (1000000.0 if dt > 1.0 else age)  # an endless pause is a gap for the next sample
    estimate = K
    own_variance = P_36
    pivot_5 = P_55
    inv_pivot_5 = (1.0/(pivot_5 if (pivot_5) > (1e-24 + 1e-06*P_55) else 1e-24 + 1e-06*P_55))
    lean_5 = P_38
    row_5_6 = P_56
    ratio_5_6 = inv_pivot_5*row_5_6
    row_5_7 = P_57
    ratio_5_7 = inv_pivot_5*row_5_7
    row_5_8 = P_58
    ratio_5_8 = inv_pivot_5*row_5_8
    row_5_9 = P_59
    ratio_5_9 = inv_pivot_5*row_5_9
    pivot_6 = P_63 - ratio_5_6*row_5_6
    inv_pivot_6 = (1.0/(pivot_6 if (pivot_6) > (1e-24 + 1e-06*P_63) else 1e-24 + 1e-06*P_63))
    lean_6 = P_39 - lean_5*ratio_5_6
    row_6_7 = P_64 - ratio_5_6*row_5_7
    ratio_6_7 = inv_pivot_6*row_6_7
    row_6_8 = P_65 - ratio_5_6*row_5_8
    ratio_6_8 = inv_pivot_6*row_6_8
    row_6_9 = P_66 - ratio_5_6*row_5_9
    ratio_6_9 = inv_pivot_6*row_6_9
    pivot_7 = P_70 - ratio_5_7*row_5_7 - ratio_6_7*row_6_7
    inv_pivot_7 = (1.0/(pivot_7 if (pivot_7) > (1e-24 + 1e-06*P_70) else 1e-24 + 1e-06*P_70))
    lean_7 = P_40 - lean_5*ratio_5_7 - lean_6*ratio_6_7
    row_7_8 = P_71 - ratio_5_7*row_5_8 - ratio_6_7*row_6_8
    ratio_7_8 = inv_pivot_7*row_7_8
    row_7_9 = P_72 - ratio_5_7*row_5_9 - ratio_6_7*row_6_9
    ratio_7_9 = inv_pivot_7*row_7_9
    pivot_8 = P_76 - ratio_5_8*row_5_8 - ratio_6_8*row_6_8 - ratio_7_8*row_7_8
    inv_pivot_8 = (1.0/(pivot_8 if (pivot_8) > (1e-24 + 1e-06*P_76) else 1e-24 + 1e-06*P_76))
    lean_8 = P_41 - lean_5*ratio_5_8 - lean_6*ratio_6_8 - lean_7*ratio_7_8
    row_8_9 = P_77 - ratio_5_8*row_5_9 - ratio_6_8*row_6_9 - ratio_7_8*row_7_9
    ratio_8_9 = inv_pivot_8*row_8_9
    pivot_9 = P_81 - ratio_5_9*row_5_9 - ratio_6_9*row_6_9 - ratio_7_9*row_7_9 - ratio_8_9*row_8_9
    inv_pivot_9 = (1.0/(pivot_9 if (pivot_9) > (1e-24 + 1e-06*P_81) else 1e-24 + 1e-06*P_81))
    lean_9 = P_42 - lean_5*ratio_5_9 - lean_6*ratio_6_9 - lean_7*ratio_7_9 - lean_8*ratio_8_9
    leant = inv_pivot_5*(lean_5*lean_5) + inv_pivot_6*(lean_6*lean_6) + inv_pivot_7*(lean_7*lean_7) + inv_pivot_8*(lean_8*lean_8) + inv_pivot_9*(lean_9*lean_9)  # of it, what would go if the constants were known
    variance = P_36 + slow_doubt*(P_36 if (P_36) < (leant) else leant)
    information_gained = information
    pi1_now = pi1
    eta_now = eta
    rho_now = rho
    grip_now = grip
    place_now = place
    offset_now = input_offset
    bias_now = output_bias
    state[:] = [v_star, r_star, v_star_plain, r_star_plain, input_offset_plain, disturbance, K, pi1, eta, rho, grip, place, input_scale, input_offset, output_bias, ay_bias, ay_activity, ay_noise_scale, P_0, P_1, P_2, P_3, P_4, P_5, P_6, P_7, P_8, P_9, P_10, P_11, P_12, P_13, P_14, P_15, P_16, P_17, P_18, P_19, P_20, P_21, P_22, P_23, P_24, P_25, P_26, P_27, P_28, P_29, P_30, P_31, P_32, P_33, P_34, P_35, P_36, P_37, P_38, P_39, P_40, P_41, P_42, P_43, P_44, P_45, P_46, P_47, P_48, P_49, P_50, P_51, P_52, P_53, P_54, P_55, P_56, P_57, P_58, P_59, P_60, P_61, P_62, P_63, P_64, P_65, P_66, P_67, P_68, P_69, P_70, P_71, P_72, P_73, P_74, P_75, P_76, P_77, P_78, P_79, P_80, P_81, P_82, P_83, P_84, P_85, P_86, P_87, P_88, P_89, P_90, noise_scale, disturbance_scale, activity, settling, restlessness, jump, surprise, heard, excitation, excited, unlearnt, untaught, validity, information, last_input, last_U, age, started]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance, information_gained, own_variance, pi1_now, eta_now, rho_now, grip_now, place_now, offset_now, bias_now, noise_now, disturbance_now]
