"""Population filter of the saturating_bicycle: layout and scalar twin. Generated from its model by similitude; do not edit.

model: saturating_bicycle, Brennan & Alleyne 2004, eqs 1-4, with saturating tyres
base: m, L, U
unknowns: K, pi1, eta, rho, grip
coordinates: v_star, r_star, disturbance, K, pi1, eta, rho, grip, input_scale, input_offset, output_bias

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'saturating_bicycle_population'
OPERATIONS = 1495
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ('v_star', 'r_star', 'disturbance', 'K', 'pi1', 'eta', 'rho', 'grip', 'input_scale', 'input_offset', 'output_bias')
REPORTS = False  # outputs are worked out when they are asked for, by a function of their own

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('K_prior', 'm^2/s^2', 'prior of Caf L/m, front cornering stiffness per mass and length', 1),
    ('pi1_prior', '-', 'prior of a/L, position of the centre of gravity', 1),
    ('eta_prior', '-', 'prior of rear over front cornering coefficient; > 1 understeers', 1),
    ('rho_prior', '-', 'prior of Iz/(m a b), yaw inertia ratio', 1),
    ('grip_prior', 'm/s^2', 'prior of mu g, greatest lateral acceleration', 1),
    ('P_prior', '-', "prior covariance of the unknowns' coordinates, upper triangle", 15),
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
    ('input_scale', '-', 'delta that acts over delta measured', 1),
    ('input_offset', 'rad', 'offset of delta', 1),
    ('output_bias', 'rad/s', 'bias of r', 1),
    ('P', '-', 'covariance of the coordinates above, upper triangle by rows', 66),
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
    P_prior_0 = config[6]
    P_prior_1 = config[7]
    P_prior_2 = config[8]
    P_prior_3 = config[9]
    P_prior_4 = config[10]
    P_prior_5 = config[11]
    P_prior_6 = config[12]
    P_prior_7 = config[13]
    P_prior_8 = config[14]
    P_prior_9 = config[15]
    P_prior_10 = config[16]
    P_prior_11 = config[17]
    P_prior_12 = config[18]
    P_prior_13 = config[19]
    P_prior_14 = config[20]
    input_scale_sd = config[32]
    input_offset_sd = config[35]
    output_bias_sd = config[36]
    v_star_sd = config[37]
    r_star_sd = config[38]
    disturbance_floor = config[50]
    disturbance_scale_start = config[54]
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
    P_0 = (v_star_sd*v_star_sd)
    P_11 = (r_star_sd*r_star_sd)
    P_60 = (input_scale_sd*input_scale_sd)
    P_63 = (input_offset_sd*input_offset_sd)
    P_65 = (output_bias_sd*output_bias_sd)
    P_30 = P_prior_0
    P_31 = P_prior_1
    P_32 = P_prior_2
    P_33 = P_prior_3
    P_34 = P_prior_4
    P_38 = P_prior_5
    P_39 = P_prior_6
    P_40 = P_prior_7
    P_41 = P_prior_8
    P_45 = P_prior_9
    P_46 = P_prior_10
    P_47 = P_prior_11
    P_51 = P_prior_12
    P_52 = P_prior_13
    P_56 = P_prior_14
    noise_scale = 1.0
    surprise = 1.0
    settling = 1.0
    disturbance_scale = disturbance_scale_start
    P_21 = disturbance_scale*(disturbance_floor*disturbance_floor)
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
    input_offset_plain = 0.0
    return [v_star, r_star, v_star_plain, r_star_plain, input_offset_plain, disturbance, K, pi1, eta, rho, grip, input_scale, input_offset, output_bias, P_0, P_1, P_2, P_3, P_4, P_5, P_6, P_7, P_8, P_9, P_10, P_11, P_12, P_13, P_14, P_15, P_16, P_17, P_18, P_19, P_20, P_21, P_22, P_23, P_24, P_25, P_26, P_27, P_28, P_29, P_30, P_31, P_32, P_33, P_34, P_35, P_36, P_37, P_38, P_39, P_40, P_41, P_42, P_43, P_44, P_45, P_46, P_47, P_48, P_49, P_50, P_51, P_52, P_53, P_54, P_55, P_56, P_57, P_58, P_59, P_60, P_61, P_62, P_63, P_64, P_65, noise_scale, disturbance_scale, activity, settling, restlessness, jump, surprise, heard, excitation, excited, unlearnt, untaught, validity, information, last_input, last_U, age, started]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    L = config[0]
    K_prior = config[1]
    prior_information = config[21]
    K_low = config[22]
    K_high = config[23]
    pi1_low = config[24]
    pi1_high = config[25]
    eta_low = config[26]
    eta_high = config[27]
    rho_low = config[28]
    rho_high = config[29]
    grip_low = config[30]
    grip_high = config[31]
    input_scale_low = config[33]
    input_scale_high = config[34]
    v_star_sd = config[37]
    r_star_sd = config[38]
    noise_variance = config[39]
    drift = config[40]
    idle_drift = config[41]
    jump_drift = config[42]
    bias_drift = config[43]
    timing_error = config[44]
    companion_rate = config[45]
    offset_rate = config[46]
    structure_share = config[47]
    structure_time = config[48]
    activity_rate = config[49]
    disturbance_floor = config[50]
    disturbance_share = config[51]
    disturbance_rate = config[52]
    disturbance_adapt = config[53]
    disturbance_scale_low = config[55]
    disturbance_scale_high = config[56]
    noise_adapt = config[57]
    noise_scale_low = config[58]
    noise_scale_high = config[59]
    excitation_ratio = config[60]
    excitation_rate = config[61]
    seldom = config[62]
    beyond_time = config[63]
    slow_doubt = config[64]
    surprise_rate = config[65]
    jump_ratio = config[66]
    surprise_limit = config[67]
    heard_rate = config[68]
    faint_drift = config[69]
    inv_telling = config[70]
    observed_least = config[71]
    outlier_ratio = config[72]
    gap = config[73]
    input_limit = config[74]
    output_limit = config[75]
    signal_limit = config[76]
    validity_limit = config[77]
    validity_rate = config[78]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
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
    input_scale = state[11]
    input_offset = state[12]
    output_bias = state[13]
    P_0 = state[14]
    P_1 = state[15]
    P_2 = state[16]
    P_3 = state[17]
    P_4 = state[18]
    P_5 = state[19]
    P_6 = state[20]
    P_7 = state[21]
    P_8 = state[22]
    P_9 = state[23]
    P_10 = state[24]
    P_11 = state[25]
    P_12 = state[26]
    P_13 = state[27]
    P_14 = state[28]
    P_15 = state[29]
    P_16 = state[30]
    P_17 = state[31]
    P_18 = state[32]
    P_19 = state[33]
    P_20 = state[34]
    P_21 = state[35]
    P_22 = state[36]
    P_23 = state[37]
    P_24 = state[38]
    P_25 = state[39]
    P_26 = state[40]
    P_27 = state[41]
    P_28 = state[42]
    P_29 = state[43]
    P_30 = state[44]
    P_31 = state[45]
    P_32 = state[46]
    P_33 = state[47]
    P_34 = state[48]
    P_35 = state[49]
    P_36 = state[50]
    P_37 = state[51]
    P_38 = state[52]
    P_39 = state[53]
    P_40 = state[54]
    P_41 = state[55]
    P_42 = state[56]
    P_43 = state[57]
    P_44 = state[58]
    P_45 = state[59]
    P_46 = state[60]
    P_47 = state[61]
    P_48 = state[62]
    P_49 = state[63]
    P_50 = state[64]
    P_51 = state[65]
    P_52 = state[66]
    P_53 = state[67]
    P_54 = state[68]
    P_55 = state[69]
    P_56 = state[70]
    P_57 = state[71]
    P_58 = state[72]
    P_59 = state[73]
    P_60 = state[74]
    P_61 = state[75]
    P_62 = state[76]
    P_63 = state[77]
    P_64 = state[78]
    P_65 = state[79]
    noise_scale = state[80]
    disturbance_scale = state[81]
    activity = state[82]
    settling = state[83]
    restlessness = state[84]
    jump = state[85]
    surprise = state[86]
    heard = state[87]
    excitation = state[88]
    excited = state[89]
    unlearnt = state[90]
    untaught = state[91]
    validity = state[92]
    information = state[93]
    last_input = state[94]
    last_U = state[95]
    age = state[96]
    started = state[97]
    U_now = 0.0
    anew = 0.0
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
            P_0 = (v_star_sd*v_star_sd)
            P_11 = (r_star_sd*r_star_sd)
            P_21 = disturbance_scale*(disturbance_floor*disturbance_floor)
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
            P_13 = P_13*keep
            P_22 = P_22*keep
            P_30 = P_30*keep
            P_31 = P_31*keep
            P_32 = P_32*keep
            P_33 = P_33*keep
            P_34 = P_34*keep
            P_35 = P_35*keep
            P_36 = P_36*keep
            P_37 = P_37*keep
            P_30 = P_30*keep
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
        PW_0 = P_2 + P_9 + P_8*steer
        FP_0_0 = F_v_star_K*P_3 + F_v_star_eta*P_5 + F_v_star_grip*P_7 + F_v_star_pi1*P_4 + F_v_star_r_star*P_1 + F_v_star_rho*P_6 + F_v_star_u*PW_0 + F_v_star_v_star*P_0
        FP_1_0 = F_r_star_K*P_3 + F_r_star_eta*P_5 + F_r_star_grip*P_7 + F_r_star_pi1*P_4 + F_r_star_r_star*P_1 + F_r_star_rho*P_6 + F_r_star_u*PW_0 + F_r_star_v_star*P_0
        PW_1 = P_12 + P_19 + P_18*steer
        FP_0_1 = F_v_star_K*P_13 + F_v_star_eta*P_15 + F_v_star_grip*P_17 + F_v_star_pi1*P_14 + F_v_star_r_star*P_11 + F_v_star_rho*P_16 + F_v_star_u*PW_1 + F_v_star_v_star*P_1
        FP_1_1 = F_r_star_K*P_13 + F_r_star_eta*P_15 + F_r_star_grip*P_17 + F_r_star_pi1*P_14 + F_r_star_r_star*P_11 + F_r_star_rho*P_16 + F_r_star_u*PW_1 + F_r_star_v_star*P_1
        P_0 = FP_0_0*F_v_star_v_star + FP_0_1*F_v_star_r_star
        P_1 = FP_0_0*F_r_star_v_star + FP_0_1*F_r_star_r_star
        P_11 = FP_1_0*F_r_star_v_star + FP_1_1*F_r_star_r_star
        PW_2 = P_21 + P_28 + P_27*steer
        FP_0_2 = F_v_star_K*P_22 + F_v_star_eta*P_24 + F_v_star_grip*P_26 + F_v_star_pi1*P_23 + F_v_star_r_star*P_12 + F_v_star_rho*P_25 + F_v_star_u*PW_2 + F_v_star_v_star*P_2
        FP_1_2 = F_r_star_K*P_22 + F_r_star_eta*P_24 + F_r_star_grip*P_26 + F_r_star_pi1*P_23 + F_r_star_r_star*P_12 + F_r_star_rho*P_25 + F_r_star_u*PW_2 + F_r_star_v_star*P_2
        P_2 = FP_0_2*keep_w
        P_12 = FP_1_2*keep_w
        PW_3 = P_22 + P_36 + P_35*steer
        FP_0_3 = F_v_star_K*P_30 + F_v_star_eta*P_32 + F_v_star_grip*P_34 + F_v_star_pi1*P_31 + F_v_star_r_star*P_13 + F_v_star_rho*P_33 + F_v_star_u*PW_3 + F_v_star_v_star*P_3
        FP_1_3 = F_r_star_K*P_30 + F_r_star_eta*P_32 + F_r_star_grip*P_34 + F_r_star_pi1*P_31 + F_r_star_r_star*P_13 + F_r_star_rho*P_33 + F_r_star_u*PW_3 + F_r_star_v_star*P_3
        P_3 = FP_0_3
        P_13 = FP_1_3
        P_0 = P_0 + FP_0_3*F_v_star_K
        P_1 = P_1 + FP_0_3*F_r_star_K
        P_11 = P_11 + FP_1_3*F_r_star_K
        PW_4 = P_23 + P_43 + P_42*steer
        FP_0_4 = F_v_star_K*P_31 + F_v_star_eta*P_39 + F_v_star_grip*P_41 + F_v_star_pi1*P_38 + F_v_star_r_star*P_14 + F_v_star_rho*P_40 + F_v_star_u*PW_4 + F_v_star_v_star*P_4
        FP_1_4 = F_r_star_K*P_31 + F_r_star_eta*P_39 + F_r_star_grip*P_41 + F_r_star_pi1*P_38 + F_r_star_r_star*P_14 + F_r_star_rho*P_40 + F_r_star_u*PW_4 + F_r_star_v_star*P_4
        P_4 = FP_0_4
        P_14 = FP_1_4
        P_0 = P_0 + FP_0_4*F_v_star_pi1
        P_1 = P_1 + FP_0_4*F_r_star_pi1
        P_11 = P_11 + FP_1_4*F_r_star_pi1
        PW_5 = P_24 + P_49 + P_48*steer
        FP_0_5 = F_v_star_K*P_32 + F_v_star_eta*P_45 + F_v_star_grip*P_47 + F_v_star_pi1*P_39 + F_v_star_r_star*P_15 + F_v_star_rho*P_46 + F_v_star_u*PW_5 + F_v_star_v_star*P_5
        FP_1_5 = F_r_star_K*P_32 + F_r_star_eta*P_45 + F_r_star_grip*P_47 + F_r_star_pi1*P_39 + F_r_star_r_star*P_15 + F_r_star_rho*P_46 + F_r_star_u*PW_5 + F_r_star_v_star*P_5
        P_5 = FP_0_5
        P_15 = FP_1_5
        P_0 = P_0 + FP_0_5*F_v_star_eta
        P_1 = P_1 + FP_0_5*F_r_star_eta
        P_11 = P_11 + FP_1_5*F_r_star_eta
        PW_6 = P_25 + P_54 + P_53*steer
        FP_0_6 = F_v_star_K*P_33 + F_v_star_eta*P_46 + F_v_star_grip*P_52 + F_v_star_pi1*P_40 + F_v_star_r_star*P_16 + F_v_star_rho*P_51 + F_v_star_u*PW_6 + F_v_star_v_star*P_6
        FP_1_6 = F_r_star_K*P_33 + F_r_star_eta*P_46 + F_r_star_grip*P_52 + F_r_star_pi1*P_40 + F_r_star_r_star*P_16 + F_r_star_rho*P_51 + F_r_star_u*PW_6 + F_r_star_v_star*P_6
        P_6 = FP_0_6
        P_16 = FP_1_6
        P_0 = P_0 + FP_0_6*F_v_star_rho
        P_1 = P_1 + FP_0_6*F_r_star_rho
        P_11 = P_11 + FP_1_6*F_r_star_rho
        PW_7 = P_26 + P_58 + P_57*steer
        FP_0_7 = F_v_star_K*P_34 + F_v_star_eta*P_47 + F_v_star_grip*P_56 + F_v_star_pi1*P_41 + F_v_star_r_star*P_17 + F_v_star_rho*P_52 + F_v_star_u*PW_7 + F_v_star_v_star*P_7
        FP_1_7 = F_r_star_K*P_34 + F_r_star_eta*P_47 + F_r_star_grip*P_56 + F_r_star_pi1*P_41 + F_r_star_r_star*P_17 + F_r_star_rho*P_52 + F_r_star_u*PW_7 + F_r_star_v_star*P_7
        P_7 = FP_0_7
        P_17 = FP_1_7
        P_0 = P_0 + FP_0_7*F_v_star_grip
        P_1 = P_1 + FP_0_7*F_r_star_grip
        P_11 = P_11 + FP_1_7*F_r_star_grip
        PW_8 = P_27 + P_61 + P_60*steer
        FP_0_8 = F_v_star_K*P_35 + F_v_star_eta*P_48 + F_v_star_grip*P_57 + F_v_star_pi1*P_42 + F_v_star_r_star*P_18 + F_v_star_rho*P_53 + F_v_star_u*PW_8 + F_v_star_v_star*P_8
        FP_1_8 = F_r_star_K*P_35 + F_r_star_eta*P_48 + F_r_star_grip*P_57 + F_r_star_pi1*P_42 + F_r_star_r_star*P_18 + F_r_star_rho*P_53 + F_r_star_u*PW_8 + F_r_star_v_star*P_8
        P_8 = FP_0_8
        P_18 = FP_1_8
        PW_9 = P_28 + P_63 + P_61*steer
        FP_0_9 = F_v_star_K*P_36 + F_v_star_eta*P_49 + F_v_star_grip*P_58 + F_v_star_pi1*P_43 + F_v_star_r_star*P_19 + F_v_star_rho*P_54 + F_v_star_u*PW_9 + F_v_star_v_star*P_9
        FP_1_9 = F_r_star_K*P_36 + F_r_star_eta*P_49 + F_r_star_grip*P_58 + F_r_star_pi1*P_43 + F_r_star_r_star*P_19 + F_r_star_rho*P_54 + F_r_star_u*PW_9 + F_r_star_v_star*P_9
        P_9 = FP_0_9
        P_19 = FP_1_9
        PW_10 = P_29 + P_64 + P_62*steer
        FP_0_10 = F_v_star_K*P_37 + F_v_star_eta*P_50 + F_v_star_grip*P_59 + F_v_star_pi1*P_44 + F_v_star_r_star*P_20 + F_v_star_rho*P_55 + F_v_star_u*PW_10 + F_v_star_v_star*P_10
        FP_1_10 = F_r_star_K*P_37 + F_r_star_eta*P_50 + F_r_star_grip*P_59 + F_r_star_pi1*P_44 + F_r_star_r_star*P_20 + F_r_star_rho*P_55 + F_r_star_u*PW_10 + F_r_star_v_star*P_10
        P_10 = FP_0_10
        P_20 = FP_1_10
        WPF_0 = FP_0_2 + FP_0_9 + FP_0_8*steer
        WPF_1 = FP_1_2 + FP_1_9 + FP_1_8*steer
        P_0 = P_0 + F_v_star_u*WPF_0
        P_1 = P_1 + F_r_star_u*WPF_0
        P_11 = P_11 + F_r_star_u*WPF_1
        P_21 = P_21*(keep_w*keep_w) + disturbance_scale*w_nominal*(1.0 - (keep_w*keep_w))
        P_22 = P_22*keep_w
        P_23 = P_23*keep_w
        P_24 = P_24*keep_w
        P_25 = P_25*keep_w
        P_26 = P_26*keep_w
        P_27 = P_27*keep_w
        P_28 = P_28*keep_w
        P_29 = P_29*keep_w
        P_30 = P_30 + dt*(diffusion + jump*jump_drift)
        P_65 = P_65 + bias_drift*dt
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
            c_1 = P_20 + P_11*output_scale
            c_3 = P_37 + P_13*output_scale
            c_10 = P_65 + P_20*output_scale
            innovation = measured - predicted
            innovation_variance = c_10 + noise + c_1*output_scale
            inv_spread = (1.0/innovation_variance)
            nis = inv_spread*(innovation*innovation)  # normalised innovation squared
            if nis > outlier_ratio:  # an outlier counts for less
                inv_spread = inv_spread*outlier_ratio/nis
            inv_P = (1.0/P_30)
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
            c_0 = P_10 + P_1*output_scale
            c_2 = P_29 + P_12*output_scale
            c_4 = P_44 + P_14*output_scale
            c_5 = P_50 + P_15*output_scale
            c_6 = P_55 + P_16*output_scale
            c_7 = P_59 + P_17*output_scale
            c_8 = P_62 + P_18*output_scale
            c_9 = P_64 + P_19*output_scale
            gain_0 = c_0*inv_spread
            gain_1 = c_1*inv_spread
            gain_2 = c_2*inv_spread
            gain_4 = c_4*learn_seldom
            gain_5 = c_5*learn_slow
            gain_6 = c_6*learn_slow
            gain_7 = c_7*learn_beyond
            gain_8 = c_8*learn_slow
            gain_9 = c_9*inv_spread
            gain_10 = c_10*inv_spread
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
            P_11 = P_11 - c_1*gain_1
            P_12 = P_12 - c_2*gain_1
            P_13 = P_13 - c_3*gain_1
            P_14 = P_14 - c_4*gain_1
            P_15 = P_15 - c_5*gain_1
            P_16 = P_16 - c_6*gain_1
            P_17 = P_17 - c_7*gain_1
            P_18 = P_18 - c_8*gain_1
            P_19 = P_19 - c_9*gain_1
            P_20 = P_20 - c_10*gain_1
            P_21 = P_21 - c_2*gain_2
            P_22 = P_22 - c_3*gain_2
            P_23 = P_23 - c_4*gain_2
            P_24 = P_24 - c_5*gain_2
            P_25 = P_25 - c_6*gain_2
            P_26 = P_26 - c_7*gain_2
            P_27 = P_27 - c_8*gain_2
            P_28 = P_28 - c_9*gain_2
            P_29 = P_29 - c_10*gain_2
            P_30 = P_30 - c_3*gain_3
            P_31 = P_31 - c_4*gain_3
            P_32 = P_32 - c_5*gain_3
            P_33 = P_33 - c_6*gain_3
            P_34 = P_34 - c_3*gain_7
            P_35 = P_35 - c_8*gain_3
            P_36 = P_36 - c_3*gain_9
            P_37 = P_37 - c_3*gain_10
            P_38 = P_38 - c_4*gain_4
            P_39 = P_39 - c_4*gain_5
            P_40 = P_40 - c_4*gain_6
            P_41 = P_41 - c_4*gain_7
            P_42 = P_42 - c_4*gain_8
            P_43 = P_43 - c_4*gain_9
            P_44 = P_44 - c_4*gain_10
            P_45 = P_45 - c_5*gain_5
            P_46 = P_46 - c_6*gain_5
            P_47 = P_47 - c_5*gain_7
            P_48 = P_48 - c_8*gain_5
            P_49 = P_49 - c_5*gain_9
            P_50 = P_50 - c_5*gain_10
            P_51 = P_51 - c_6*gain_6
            P_52 = P_52 - c_6*gain_7
            P_53 = P_53 - c_8*gain_6
            P_54 = P_54 - c_6*gain_9
            P_55 = P_55 - c_6*gain_10
            P_56 = P_56 - c_7*gain_7
            P_57 = P_57 - c_8*gain_7
            P_58 = P_58 - c_7*gain_9
            P_59 = P_59 - c_7*gain_10
            P_60 = P_60 - c_8*gain_8
            P_61 = P_61 - c_8*gain_9
            P_62 = P_62 - c_8*gain_10
            P_63 = P_63 - c_9*gain_9
            P_64 = P_64 - c_10*gain_9
            P_65 = P_65 - c_10*gain_10
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
            move_input_scale = gain_8*innovation
            above_move_input_scale = ((-1.0) if ((-1.0)) > (move_input_scale) else move_input_scale)
            bounded_move_input_scale = (1.0 if (1.0) < (above_move_input_scale) else above_move_input_scale)
            input_scale = input_scale*(1.0 + bounded_move_input_scale*(1.0 + bounded_move_input_scale*(0.5 + 0.16666666666666666*bounded_move_input_scale)))
            input_offset = input_offset + gain_9*innovation
            output_bias = output_bias + gain_10*innovation
            settling = (noise_adapt if (noise_adapt) > (settling - dt*(settling*settling)) else settling - dt*(settling*settling))  # 1/time at first
            noise_change = odd*(0.05 if (0.05) < (dt*settling) else dt*settling)
            noise_scale = noise_scale*(1.0 + noise_change*(1.0 + noise_change*(0.5 + 0.16666666666666666*noise_change)))
            noise_scale = (noise_scale if (noise_scale) > (noise_scale_low) else noise_scale_low)
            noise_scale = (noise_scale if (noise_scale) < (noise_scale_high) else noise_scale_high)
            expected = disturbance_scale*w_nominal  # disturbance variance expected
            seen = (9.0*expected if (9.0*expected) < (P_21 + (disturbance*disturbance)) else P_21 + (disturbance*disturbance))  # and seen
            unseen = (expected*observed_least if (expected*observed_least) > (expected - P_21) else expected - P_21)
            disturbance_scale = disturbance_scale + disturbance_scale*(seen - expected)*(1.0 if (1.0) < (disturbance_adapt*dt) else disturbance_adapt*dt)/unseen
            disturbance_scale = (disturbance_scale if (disturbance_scale) > (disturbance_scale_low) else disturbance_scale_low)
            disturbance_scale = (disturbance_scale if (disturbance_scale) < (disturbance_scale_high) else disturbance_scale_high)
            if (excited < 0.5) and (status < 0.5):
                status = 1.0
            if (status < 1.5) and (validity > (validity_limit*validity_limit)):
                status = 2.0
        above_move = ((-1.0) if ((-1.0)) > (move) else move)
        bounded_move = (1.0 if (1.0) < (above_move) else above_move)
        K = K*(1.0 + bounded_move*(1.0 + bounded_move*(0.5 + 0.16666666666666666*bounded_move)))
        if (K < K_low) or (K > K_high) or (eta < eta_low) or (eta > eta_high) or (grip < grip_low) or (grip > grip_high) or (input_scale < input_scale_low) or (input_scale > input_scale_high) or (pi1 < pi1_low) or (pi1 > pi1_high) or (rho < rho_low) or (rho > rho_high):  # prior +- its allowed range
            K = (K_high if (K_high) < ((K if (K) > (K_low) else K_low)) else (K if (K) > (K_low) else K_low))
            pi1 = (pi1_high if (pi1_high) < ((pi1 if (pi1) > (pi1_low) else pi1_low)) else (pi1 if (pi1) > (pi1_low) else pi1_low))
            eta = (eta_high if (eta_high) < ((eta if (eta) > (eta_low) else eta_low)) else (eta if (eta) > (eta_low) else eta_low))
            rho = (rho_high if (rho_high) < ((rho if (rho) > (rho_low) else rho_low)) else (rho if (rho) > (rho_low) else rho_low))
            grip = (grip_high if (grip_high) < ((grip if (grip) > (grip_low) else grip_low)) else (grip if (grip) > (grip_low) else grip_low))
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
    own_variance = P_30
    pivot_5 = P_45
    inv_pivot_5 = (1.0/(pivot_5 if (pivot_5) > (1e-24 + 1e-06*P_45) else 1e-24 + 1e-06*P_45))
    lean_5 = P_32
    row_5_6 = P_46
    ratio_5_6 = inv_pivot_5*row_5_6
    row_5_7 = P_47
    ratio_5_7 = inv_pivot_5*row_5_7
    row_5_8 = P_48
    ratio_5_8 = inv_pivot_5*row_5_8
    pivot_6 = P_51 - ratio_5_6*row_5_6
    inv_pivot_6 = (1.0/(pivot_6 if (pivot_6) > (1e-24 + 1e-06*P_51) else 1e-24 + 1e-06*P_51))
    lean_6 = P_33 - lean_5*ratio_5_6
    row_6_7 = P_52 - ratio_5_6*row_5_7
    ratio_6_7 = inv_pivot_6*row_6_7
    row_6_8 = P_53 - ratio_5_6*row_5_8
    ratio_6_8 = inv_pivot_6*row_6_8
    pivot_7 = P_56 - ratio_5_7*row_5_7 - ratio_6_7*row_6_7
    inv_pivot_7 = (1.0/(pivot_7 if (pivot_7) > (1e-24 + 1e-06*P_56) else 1e-24 + 1e-06*P_56))
    lean_7 = P_34 - lean_5*ratio_5_7 - lean_6*ratio_6_7
    row_7_8 = P_57 - ratio_5_7*row_5_8 - ratio_6_7*row_6_8
    ratio_7_8 = inv_pivot_7*row_7_8
    pivot_8 = P_60 - ratio_5_8*row_5_8 - ratio_6_8*row_6_8 - ratio_7_8*row_7_8
    inv_pivot_8 = (1.0/(pivot_8 if (pivot_8) > (1e-24 + 1e-06*P_60) else 1e-24 + 1e-06*P_60))
    lean_8 = P_35 - lean_5*ratio_5_8 - lean_6*ratio_6_8 - lean_7*ratio_7_8
    leant = inv_pivot_5*(lean_5*lean_5) + inv_pivot_6*(lean_6*lean_6) + inv_pivot_7*(lean_7*lean_7) + inv_pivot_8*(lean_8*lean_8)  # of it, what would go if the constants were known
    variance = P_30 + slow_doubt*(P_30 if (P_30) < (leant) else leant)
    information_gained = information
    pi1_now = pi1
    eta_now = eta
    rho_now = rho
    grip_now = grip
    offset_now = input_offset
    bias_now = output_bias
    state[:] = [v_star, r_star, v_star_plain, r_star_plain, input_offset_plain, disturbance, K, pi1, eta, rho, grip, input_scale, input_offset, output_bias, P_0, P_1, P_2, P_3, P_4, P_5, P_6, P_7, P_8, P_9, P_10, P_11, P_12, P_13, P_14, P_15, P_16, P_17, P_18, P_19, P_20, P_21, P_22, P_23, P_24, P_25, P_26, P_27, P_28, P_29, P_30, P_31, P_32, P_33, P_34, P_35, P_36, P_37, P_38, P_39, P_40, P_41, P_42, P_43, P_44, P_45, P_46, P_47, P_48, P_49, P_50, P_51, P_52, P_53, P_54, P_55, P_56, P_57, P_58, P_59, P_60, P_61, P_62, P_63, P_64, P_65, noise_scale, disturbance_scale, activity, settling, restlessness, jump, surprise, heard, excitation, excited, unlearnt, untaught, validity, information, last_input, last_U, age, started]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance, information_gained, own_variance, pi1_now, eta_now, rho_now, grip_now, offset_now, bias_now, noise_now, disturbance_now]
