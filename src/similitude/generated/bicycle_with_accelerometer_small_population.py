"""Small population filter of the bicycle_with_accelerometer: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle_with_accelerometer, Brennan & Alleyne 2004, eqs 1-4
base: m, L, U
unknowns: K, pi1, eta, rho, lead
coordinates: v_star, r_star, disturbance, K, pi1, eta, rho, lead, output_bias, ay_bias

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_with_accelerometer_small_population'
OPERATIONS = 1272
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ('v_star', 'r_star', 'disturbance', 'K', 'pi1', 'eta', 'rho', 'lead', 'output_bias', 'ay_bias')
REPORTS = False  # outputs are worked out when they are asked for, by a function of their own

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('K_prior', 'm^2/s^2', 'prior of Caf L/m, front cornering stiffness per mass and length', 1),
    ('pi1_prior', '-', 'prior of a/L, position of the centre of gravity', 1),
    ('eta_prior', '-', 'prior of rear over front cornering coefficient; > 1 understeers', 1),
    ('rho_prior', '-', 'prior of Iz/(m a b), yaw inertia ratio', 1),
    ('lead_prior', '-', 'prior of accelerometer ahead of the centre of gravity over L', 1),
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
    ('lead_low', '-', 'lowest value the population allows', 1),
    ('lead_high', '-', 'highest value the population allows', 1),
    ('output_bias_sd', 'rad/s', 'prior sd of the bias of r', 1),
    ('v_star_sd', '-', 'sd after a restart', 1),
    ('r_star_sd', '-', 'sd after a restart', 1),
    ('noise_variance', '(rad/s)^2', 'white noise of r a sample', 1),
    ('drift', '1/s', 'diffusion of ln K while it is observed', 1),
    ('idle_drift', '1/s', 'diffusion of ln K while nothing is heard of it', 1),
    ('jump_drift', '1/s', 'further diffusion per unit of surprise above its limit', 1),
    ('bias_drift', '(rad/s)^2/s', 'random walk of the output bias', 1),
    ('timing_error', 's', 'timing error between input and output', 1),
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
    ('surprise_rate', '1/s', 'averaging rate of the normalised innovation', 1),
    ('jump_ratio', '-', 'squared surprise against its long-run mean that speaks of a jump', 1),
    ('surprise_limit', '-', 'mean squared normalised innovation that speaks of a jump', 1),
    ('heard_rate', '1/s', 'rate at which what was told of the first unknown is forgotten', 1),
    ('faint_drift', '1/s', 'further diffusion of ln K while a jump could not show', 1),
    ('inv_telling', '-', '1/information of late in which a jump shows', 1),
    ('observed_least', '-', 'least share of the disturbance taken as observed', 1),
    ('outlier_ratio', '-', 'squared innovation over its variance beyond which it is bounded', 1),
    ('longest', 's', 'longest time a sample counts for in an average', 1),
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
    ('disturbance', 'rad', 'disturbance as an equivalent delta', 1),
    ('K', 'm^2/s^2', 'Caf L/m, front cornering stiffness per mass and length', 1),
    ('pi1', '-', 'a/L, position of the centre of gravity', 1),
    ('eta', '-', 'rear over front cornering coefficient; > 1 understeers', 1),
    ('rho', '-', 'Iz/(m a b), yaw inertia ratio', 1),
    ('lead', '-', 'accelerometer ahead of the centre of gravity over L', 1),
    ('output_bias', 'rad/s', 'bias of r', 1),
    ('ay_with', 'm/s^2', 'covariance of ay with the coordinates', 10),
    ('ay_spread', '(m/s^2)^2', 'variance of ay predicted', 1),
    ('last_ay', 'm/s^2', 'ay of the sample before', 1),
    ('ay_bias', 'm/s^2', 'bias of ay', 1),
    ('ay_activity', '(m/s^2)^2', 'mean square of ay predicted', 1),
    ('ay_noise_scale', '-', 'noise variance of ay against nominal', 1),
    ('P', '-', 'covariance of the coordinates above, upper triangle by rows', 55),
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
    ('validity', '(m/s^2)^2', 'recent peak of the validity signal, squared', 1),
    ('information', '-', 'information gained about ln K', 1),
    ('last_input', 'rad', 'input of the sample before', 1),
    ('last_U', 'm/s', 'forward speed of the sample before', 1),
    ('age', 's', 'time since the last usable sample', 1),
    ('turn', '-', 'which size adapts next: 0 disturbance, 1 noise, 2 excitation', 1),
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
)


def init(config):
    """The flat state before the first sample, from the flat configuration."""
    K_prior = config[1]
    pi1_prior = config[2]
    eta_prior = config[3]
    rho_prior = config[4]
    lead_prior = config[5]
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
    output_bias_sd = config[32]
    v_star_sd = config[33]
    r_star_sd = config[34]
    disturbance_floor = config[44]
    disturbance_scale_start = config[48]
    signal_limit = config[69]
    ay_bias_sd = config[72]
    ay_limit = config[79]
    v_star = 0.0
    r_star = 0.0
    disturbance = 0.0
    K = K_prior
    pi1 = pi1_prior
    eta = eta_prior
    rho = rho_prior
    lead = lead_prior
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
    P_0 = (v_star_sd*v_star_sd)
    P_10 = (r_star_sd*r_star_sd)
    P_52 = (output_bias_sd*output_bias_sd)
    P_54 = (ay_bias_sd*ay_bias_sd)
    P_27 = P_prior_0
    P_28 = P_prior_1
    P_29 = P_prior_2
    P_30 = P_prior_3
    P_31 = P_prior_4
    P_34 = P_prior_5
    P_35 = P_prior_6
    P_36 = P_prior_7
    P_37 = P_prior_8
    P_40 = P_prior_9
    P_41 = P_prior_10
    P_42 = P_prior_11
    P_45 = P_prior_12
    P_46 = P_prior_13
    P_49 = P_prior_14
    noise_scale = 1.0
    surprise = 1.0
    settling = 1.0
    disturbance_scale = disturbance_scale_start
    last_U = 0.0003333333333333333*signal_limit
    last_ay = 2.0*ay_limit
    ay_noise_scale = 1.0
    P_19 = disturbance_scale*(disturbance_floor*disturbance_floor)
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
    turn = 0.0
    ay_bias = 0.0
    ay_activity = 0.0
    ay_with_0 = 0.0
    ay_with_1 = 0.0
    ay_with_2 = 0.0
    ay_with_3 = 0.0
    ay_with_4 = 0.0
    ay_with_5 = 0.0
    ay_with_6 = 0.0
    ay_with_7 = 0.0
    ay_with_8 = 0.0
    ay_with_9 = 0.0
    ay_spread = 0.0
    return [v_star, r_star, disturbance, K, pi1, eta, rho, lead, output_bias, ay_with_0, ay_with_1, ay_with_2, ay_with_3, ay_with_4, ay_with_5, ay_with_6, ay_with_7, ay_with_8, ay_with_9, ay_spread, last_ay, ay_bias, ay_activity, ay_noise_scale, P_0, P_1, P_2, P_3, P_4, P_5, P_6, P_7, P_8, P_9, P_10, P_11, P_12, P_13, P_14, P_15, P_16, P_17, P_18, P_19, P_20, P_21, P_22, P_23, P_24, P_25, P_26, P_27, P_28, P_29, P_30, P_31, P_32, P_33, P_34, P_35, P_36, P_37, P_38, P_39, P_40, P_41, P_42, P_43, P_44, P_45, P_46, P_47, P_48, P_49, P_50, P_51, P_52, P_53, P_54, noise_scale, disturbance_scale, activity, settling, restlessness, jump, surprise, heard, excitation, excited, unlearnt, validity, information, last_input, last_U, age, turn, started]


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
    v_star_sd = config[33]
    r_star_sd = config[34]
    noise_variance = config[35]
    drift = config[36]
    idle_drift = config[37]
    jump_drift = config[38]
    bias_drift = config[39]
    timing_error = config[40]
    structure_share = config[41]
    structure_time = config[42]
    activity_rate = config[43]
    disturbance_floor = config[44]
    disturbance_share = config[45]
    disturbance_rate = config[46]
    disturbance_adapt = config[47]
    disturbance_scale_low = config[49]
    disturbance_scale_high = config[50]
    noise_adapt = config[51]
    noise_scale_low = config[52]
    noise_scale_high = config[53]
    excitation_ratio = config[54]
    excitation_rate = config[55]
    seldom = config[56]
    surprise_rate = config[57]
    jump_ratio = config[58]
    surprise_limit = config[59]
    heard_rate = config[60]
    faint_drift = config[61]
    inv_telling = config[62]
    observed_least = config[63]
    outlier_ratio = config[64]
    longest = config[65]
    gap = config[66]
    input_limit = config[67]
    output_limit = config[68]
    signal_limit = config[69]
    validity_limit = config[70]
    validity_rate = config[71]
    ay_bias_drift = config[73]
    ay_variance = config[74]
    ay_share = config[75]
    ay_time = config[76]
    ay_noise_scale_low = config[77]
    ay_noise_scale_high = config[78]
    ay_limit = config[79]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    ay_measured = sample[4]
    v_star = state[0]
    r_star = state[1]
    disturbance = state[2]
    K = state[3]
    pi1 = state[4]
    eta = state[5]
    rho = state[6]
    lead = state[7]
    output_bias = state[8]
    ay_with_0 = state[9]
    ay_with_1 = state[10]
    ay_with_2 = state[11]
    ay_with_3 = state[12]
    ay_with_4 = state[13]
    ay_with_5 = state[14]
    ay_with_6 = state[15]
    ay_with_7 = state[16]
    ay_with_8 = state[17]
    ay_with_9 = state[18]
    ay_spread = state[19]
    last_ay = state[20]
    ay_bias = state[21]
    ay_activity = state[22]
    ay_noise_scale = state[23]
    P_0 = state[24]
    P_1 = state[25]
    P_2 = state[26]
    P_3 = state[27]
    P_4 = state[28]
    P_5 = state[29]
    P_6 = state[30]
    P_7 = state[31]
    P_8 = state[32]
    P_9 = state[33]
    P_10 = state[34]
    P_11 = state[35]
    P_12 = state[36]
    P_13 = state[37]
    P_14 = state[38]
    P_15 = state[39]
    P_16 = state[40]
    P_17 = state[41]
    P_18 = state[42]
    P_19 = state[43]
    P_20 = state[44]
    P_21 = state[45]
    P_22 = state[46]
    P_23 = state[47]
    P_24 = state[48]
    P_25 = state[49]
    P_26 = state[50]
    P_27 = state[51]
    P_28 = state[52]
    P_29 = state[53]
    P_30 = state[54]
    P_31 = state[55]
    P_32 = state[56]
    P_33 = state[57]
    P_34 = state[58]
    P_35 = state[59]
    P_36 = state[60]
    P_37 = state[61]
    P_38 = state[62]
    P_39 = state[63]
    P_40 = state[64]
    P_41 = state[65]
    P_42 = state[66]
    P_43 = state[67]
    P_44 = state[68]
    P_45 = state[69]
    P_46 = state[70]
    P_47 = state[71]
    P_48 = state[72]
    P_49 = state[73]
    P_50 = state[74]
    P_51 = state[75]
    P_52 = state[76]
    P_53 = state[77]
    P_54 = state[78]
    noise_scale = state[79]
    disturbance_scale = state[80]
    activity = state[81]
    settling = state[82]
    restlessness = state[83]
    jump = state[84]
    surprise = state[85]
    heard = state[86]
    excitation = state[87]
    excited = state[88]
    unlearnt = state[89]
    validity = state[90]
    information = state[91]
    last_input = state[92]
    last_U = state[93]
    age = state[94]
    turn = state[95]
    started = state[96]
    U_now = 0.0
    anew = 0.0
    ay_after = 0.0
    ay_innovation = 0.0
    ay_inv_spread = 0.0
    ay_learn_seldom = 0.0
    ay_odd = 0.0
    d_r_star = 0.0
    d_v_star = 0.0
    diffusion = 0.0
    estimate = 0.0
    information_gained = 0.0
    innovation = 0.0
    innovation_variance = 0.0
    inv_spread = 0.0
    learn_seldom = 0.0
    linear = 0.0
    move = 0.0
    predicted = 0.0
    status = 0.0
    u_now = 0.0
    usable = 0.0
    variance = 0.0
    status = 0.0
    predicted = output_bias
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
        if age > gap:  # nothing was heard for long
            anew = 1.0
            if usable > 0.5:
                status = 5.0
        if (10.0*(U_now*U_now) > K_prior) and (U_now > 0.0):  # the dynamics cannot be seen
            pass
        else:
            anew = 1.0
            started = 0.0
            usable = 0.0
            status = 6.0
        least_scale = 0.0003333333333333333*signal_limit
        at_U = (U_now if (U_now) > (least_scale) else least_scale)  # kept off zero
        inv_U = (1.0/at_U)
        inv_L = (1.0/L)
        held = (dt if (dt) < (longest) else longest)
        inv_dt = (1.0/held)
        output_scale = at_U*inv_L  # r = scale x dimensionless
        inv_output_scale = L*inv_U
        h = at_U*dt*inv_L  # dimensionless time step
        w_nominal = (disturbance_floor*disturbance_floor) + activity*(disturbance_share*disturbance_share)*(inv_output_scale*inv_output_scale)  # nominal variance of the disturbance
        if anew > 0.5:  # nothing is known of the dynamic state
            excitation = 0.0
            excited = 0.0
            jump = 0.0
            heard = 0.0
            surprise = 1.0
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
            P_0 = (v_star_sd*v_star_sd)
            P_10 = (r_star_sd*r_star_sd)
            P_19 = disturbance_scale*(disturbance_floor*disturbance_floor)
            v_star = 0.0
            r_star = 0.0
            disturbance = 0.0
            d_v_star = 0.0
            d_r_star = 0.0
        else:
            ratio_v_star = inv_U*last_U  # same physical state in the new scales
            v_star = ratio_v_star*v_star
            ratio_r_star = inv_U*last_U  # same physical state in the new scales
            r_star = r_star*ratio_r_star
            steer = 0.5*last_input + 0.5*u_now  # mean of the sample's two ends
            u = disturbance + steer  # effective input [-]
            inv0 = (1.0/rho)
            inv1 = (1.0/(pi1 - 1.0))
            c0 = (-r_star)
            c1 = pi1*r_star
            c2 = c1 + v_star
            c3 = c0 + c2
            c4 = c3*eta
            c5 = inv1*pi1
            c6 = c4*c5
            c7 = u - c1 - v_star
            c8 = K*(inv_U*inv_U)
            c9 = c8*(c6 + c7)
            c10 = c4 + c7
            c11 = c8*inv0
            c12 = c11*inv1
            c13 = (-c10*c12)
            c14 = 0.3333333333333333*h
            c15 = eta - 1.0
            c16 = c4*inv1
            f_v_star = c0 + c9  # rate [-]
            f_r_star = c13  # rate [-]
            J_00 = c14*c8*(c5*eta - 1.0)
            J_01 = c14*(c15*c8*pi1 - 1.0)
            J_10 = (-c12*c14*c15)
            J_11 = c11*c14*(inv1*pi1 - eta)
            f_v_star_K = c9
            f_r_star_K = c13
            f_v_star_pi1 = c8*(c3*eta*inv1 + eta*inv1*pi1*r_star - r_star - c4*pi1*(inv1*inv1))
            f_r_star_pi1 = c12*(c16 + r_star - eta*r_star - inv1*(c2 - u))
            f_v_star_eta = c6*c8
            f_r_star_eta = (-c11*c16)
            f_v_star_rho = 0.0
            f_r_star_rho = c10*c12
            f_v_star_lead = 0.0
            f_r_star_lead = 0.0
            f_v_star_u = c8
            f_r_star_u = (-c12)
            p0 = J_00*J_11 - J_01*J_10
            p1 = (-J_00) - J_11
            n0 = 1.0 - 1.5*p0
            n1 = (-2.0) - 1.5*p1
            i_det = (1.0/((n0*n0) + p0*(n1*n1) - n0*n1*p1))  # det N > 0 for every real J
            i0 = i_det*(n0 - n1*p1)
            i1 = (-i_det*n1)
            m0 = i0 - i1*p0
            m1 = i0 + i1 - i1*p1
            M_00 = m0 + J_00*m1  # dx+/dx
            M_01 = J_01*m1
            M_10 = J_10*m1
            M_11 = m0 + J_11*m1
            g0 = h*i0 + 0.5*h*i1*p0
            g1 = h*i1 + 0.5*h*i1*p1 - 0.5*h*i0
            G_00 = g0 + J_00*g1  # change per rate
            G_01 = J_01*g1
            G_10 = J_10*g1
            G_11 = g0 + J_11*g1
            d_v_star = G_00*f_v_star + G_01*f_r_star  # change over the step [-]
            d_r_star = G_10*f_v_star + G_11*f_r_star  # change over the step [-]
            F_v_star_K = G_00*f_v_star_K + G_01*f_r_star_K
            F_r_star_K = G_10*f_v_star_K + G_11*f_r_star_K
            F_v_star_pi1 = G_00*f_v_star_pi1 + G_01*f_r_star_pi1
            F_r_star_pi1 = G_10*f_v_star_pi1 + G_11*f_r_star_pi1
            F_v_star_eta = G_00*f_v_star_eta + G_01*f_r_star_eta
            F_r_star_eta = G_10*f_v_star_eta + G_11*f_r_star_eta
            F_v_star_rho = G_00*f_v_star_rho + G_01*f_r_star_rho
            F_r_star_rho = G_10*f_v_star_rho + G_11*f_r_star_rho
            F_v_star_lead = G_00*f_v_star_lead + G_01*f_r_star_lead
            F_r_star_lead = G_10*f_v_star_lead + G_11*f_r_star_lead
            F_v_star_u = G_00*f_v_star_u + G_01*f_r_star_u
            F_r_star_u = G_10*f_v_star_u + G_11*f_r_star_u
            ay_scale = inv_L*(at_U*at_U)  # ay = scale x dimensionless
            ay_per_step = ay_scale/h
            ay_to_0 = ay_per_step
            ay_from_0 = (-ay_per_step*ratio_v_star)
            ay_to_1 = 0.5*ay_scale + ay_per_step*lead
            ay_from_1 = ratio_r_star*(0.5*ay_scale - ay_per_step*lead)
            ay_by_7 = ay_per_step*d_r_star
            F_v_star_v_star = M_00*ratio_v_star
            F_v_star_r_star = M_01*ratio_r_star
            F_r_star_v_star = M_10*ratio_v_star
            F_r_star_r_star = M_11*ratio_r_star
            keep_w = 1.0 - disturbance_rate*held
            PW_0 = P_2
            FP_0_0 = F_v_star_K*P_3 + F_v_star_eta*P_5 + F_v_star_lead*P_7 + F_v_star_pi1*P_4 + F_v_star_r_star*P_1 + F_v_star_rho*P_6 + F_v_star_u*PW_0 + F_v_star_v_star*P_0
            FP_1_0 = F_r_star_K*P_3 + F_r_star_eta*P_5 + F_r_star_lead*P_7 + F_r_star_pi1*P_4 + F_r_star_r_star*P_1 + F_r_star_rho*P_6 + F_r_star_u*PW_0 + F_r_star_v_star*P_0
            PW_1 = P_11
            FP_0_1 = F_v_star_K*P_12 + F_v_star_eta*P_14 + F_v_star_lead*P_16 + F_v_star_pi1*P_13 + F_v_star_r_star*P_10 + F_v_star_rho*P_15 + F_v_star_u*PW_1 + F_v_star_v_star*P_1
            FP_1_1 = F_r_star_K*P_12 + F_r_star_eta*P_14 + F_r_star_lead*P_16 + F_r_star_pi1*P_13 + F_r_star_r_star*P_10 + F_r_star_rho*P_15 + F_r_star_u*PW_1 + F_r_star_v_star*P_1
            ay_before_0 = P_9 + FP_0_0*ay_to_0 + FP_1_0*ay_to_1 + P_0*ay_from_0 + P_1*ay_from_1 + P_7*ay_by_7
            ay_before_1 = P_18 + FP_0_1*ay_to_0 + FP_1_1*ay_to_1 + P_1*ay_from_0 + P_10*ay_from_1 + P_16*ay_by_7
            P_0 = FP_0_0*F_v_star_v_star + FP_0_1*F_v_star_r_star
            P_1 = FP_0_0*F_r_star_v_star + FP_0_1*F_r_star_r_star
            P_10 = FP_1_0*F_r_star_v_star + FP_1_1*F_r_star_r_star
            PW_2 = P_19
            FP_0_2 = F_v_star_K*P_20 + F_v_star_eta*P_22 + F_v_star_lead*P_24 + F_v_star_pi1*P_21 + F_v_star_r_star*P_11 + F_v_star_rho*P_23 + F_v_star_u*PW_2 + F_v_star_v_star*P_2
            FP_1_2 = F_r_star_K*P_20 + F_r_star_eta*P_22 + F_r_star_lead*P_24 + F_r_star_pi1*P_21 + F_r_star_r_star*P_11 + F_r_star_rho*P_23 + F_r_star_u*PW_2 + F_r_star_v_star*P_2
            ay_with_2 = keep_w*(P_26 + FP_0_2*ay_to_0 + FP_1_2*ay_to_1 + P_11*ay_from_1 + P_2*ay_from_0 + P_24*ay_by_7)
            P_2 = FP_0_2*keep_w
            P_11 = FP_1_2*keep_w
            PW_3 = P_20
            FP_0_3 = F_v_star_K*P_27 + F_v_star_eta*P_29 + F_v_star_lead*P_31 + F_v_star_pi1*P_28 + F_v_star_r_star*P_12 + F_v_star_rho*P_30 + F_v_star_u*PW_3 + F_v_star_v_star*P_3
            FP_1_3 = F_r_star_K*P_27 + F_r_star_eta*P_29 + F_r_star_lead*P_31 + F_r_star_pi1*P_28 + F_r_star_r_star*P_12 + F_r_star_rho*P_30 + F_r_star_u*PW_3 + F_r_star_v_star*P_3
            ay_with_3 = P_33 + FP_0_3*ay_to_0 + FP_1_3*ay_to_1 + P_12*ay_from_1 + P_3*ay_from_0 + P_31*ay_by_7
            P_3 = FP_0_3
            P_12 = FP_1_3
            P_0 = P_0 + FP_0_3*F_v_star_K
            P_1 = P_1 + FP_0_3*F_r_star_K
            P_10 = P_10 + FP_1_3*F_r_star_K
            PW_4 = P_21
            FP_0_4 = F_v_star_K*P_28 + F_v_star_eta*P_35 + F_v_star_lead*P_37 + F_v_star_pi1*P_34 + F_v_star_r_star*P_13 + F_v_star_rho*P_36 + F_v_star_u*PW_4 + F_v_star_v_star*P_4
            FP_1_4 = F_r_star_K*P_28 + F_r_star_eta*P_35 + F_r_star_lead*P_37 + F_r_star_pi1*P_34 + F_r_star_r_star*P_13 + F_r_star_rho*P_36 + F_r_star_u*PW_4 + F_r_star_v_star*P_4
            ay_with_4 = P_39 + FP_0_4*ay_to_0 + FP_1_4*ay_to_1 + P_13*ay_from_1 + P_37*ay_by_7 + P_4*ay_from_0
            P_4 = FP_0_4
            P_13 = FP_1_4
            P_0 = P_0 + FP_0_4*F_v_star_pi1
            P_1 = P_1 + FP_0_4*F_r_star_pi1
            P_10 = P_10 + FP_1_4*F_r_star_pi1
            PW_5 = P_22
            FP_0_5 = F_v_star_K*P_29 + F_v_star_eta*P_40 + F_v_star_lead*P_42 + F_v_star_pi1*P_35 + F_v_star_r_star*P_14 + F_v_star_rho*P_41 + F_v_star_u*PW_5 + F_v_star_v_star*P_5
            FP_1_5 = F_r_star_K*P_29 + F_r_star_eta*P_40 + F_r_star_lead*P_42 + F_r_star_pi1*P_35 + F_r_star_r_star*P_14 + F_r_star_rho*P_41 + F_r_star_u*PW_5 + F_r_star_v_star*P_5
            ay_with_5 = P_44 + FP_0_5*ay_to_0 + FP_1_5*ay_to_1 + P_14*ay_from_1 + P_42*ay_by_7 + P_5*ay_from_0
            P_5 = FP_0_5
            P_14 = FP_1_5
            P_0 = P_0 + FP_0_5*F_v_star_eta
            P_1 = P_1 + FP_0_5*F_r_star_eta
            P_10 = P_10 + FP_1_5*F_r_star_eta
            PW_6 = P_23
            FP_0_6 = F_v_star_K*P_30 + F_v_star_eta*P_41 + F_v_star_lead*P_46 + F_v_star_pi1*P_36 + F_v_star_r_star*P_15 + F_v_star_rho*P_45 + F_v_star_u*PW_6 + F_v_star_v_star*P_6
            FP_1_6 = F_r_star_K*P_30 + F_r_star_eta*P_41 + F_r_star_lead*P_46 + F_r_star_pi1*P_36 + F_r_star_r_star*P_15 + F_r_star_rho*P_45 + F_r_star_u*PW_6 + F_r_star_v_star*P_6
            ay_with_6 = P_48 + FP_0_6*ay_to_0 + FP_1_6*ay_to_1 + P_15*ay_from_1 + P_46*ay_by_7 + P_6*ay_from_0
            P_6 = FP_0_6
            P_15 = FP_1_6
            P_0 = P_0 + FP_0_6*F_v_star_rho
            P_1 = P_1 + FP_0_6*F_r_star_rho
            P_10 = P_10 + FP_1_6*F_r_star_rho
            PW_7 = P_24
            FP_0_7 = F_v_star_K*P_31 + F_v_star_eta*P_42 + F_v_star_lead*P_49 + F_v_star_pi1*P_37 + F_v_star_r_star*P_16 + F_v_star_rho*P_46 + F_v_star_u*PW_7 + F_v_star_v_star*P_7
            FP_1_7 = F_r_star_K*P_31 + F_r_star_eta*P_42 + F_r_star_lead*P_49 + F_r_star_pi1*P_37 + F_r_star_r_star*P_16 + F_r_star_rho*P_46 + F_r_star_u*PW_7 + F_r_star_v_star*P_7
            ay_with_7 = P_51 + FP_0_7*ay_to_0 + FP_1_7*ay_to_1 + P_16*ay_from_1 + P_49*ay_by_7 + P_7*ay_from_0
            P_7 = FP_0_7
            P_16 = FP_1_7
            P_0 = P_0 + FP_0_7*F_v_star_lead
            P_1 = P_1 + FP_0_7*F_r_star_lead
            P_10 = P_10 + FP_1_7*F_r_star_lead
            PW_8 = P_25
            FP_0_8 = F_v_star_K*P_32 + F_v_star_eta*P_43 + F_v_star_lead*P_50 + F_v_star_pi1*P_38 + F_v_star_r_star*P_17 + F_v_star_rho*P_47 + F_v_star_u*PW_8 + F_v_star_v_star*P_8
            FP_1_8 = F_r_star_K*P_32 + F_r_star_eta*P_43 + F_r_star_lead*P_50 + F_r_star_pi1*P_38 + F_r_star_r_star*P_17 + F_r_star_rho*P_47 + F_r_star_u*PW_8 + F_r_star_v_star*P_8
            ay_with_8 = P_53 + FP_0_8*ay_to_0 + FP_1_8*ay_to_1 + P_17*ay_from_1 + P_50*ay_by_7 + P_8*ay_from_0
            P_8 = FP_0_8
            P_17 = FP_1_8
            PW_9 = P_26
            FP_0_9 = F_v_star_K*P_33 + F_v_star_eta*P_44 + F_v_star_lead*P_51 + F_v_star_pi1*P_39 + F_v_star_r_star*P_18 + F_v_star_rho*P_48 + F_v_star_u*PW_9 + F_v_star_v_star*P_9
            FP_1_9 = F_r_star_K*P_33 + F_r_star_eta*P_44 + F_r_star_lead*P_51 + F_r_star_pi1*P_39 + F_r_star_r_star*P_18 + F_r_star_rho*P_48 + F_r_star_u*PW_9 + F_r_star_v_star*P_9
            ay_with_9 = P_54 + FP_0_9*ay_to_0 + FP_1_9*ay_to_1 + P_18*ay_from_1 + P_51*ay_by_7 + P_9*ay_from_0
            P_9 = FP_0_9
            P_18 = FP_1_9
            WPF_0 = FP_0_2
            WPF_1 = FP_1_2
            P_0 = P_0 + F_v_star_u*WPF_0
            P_1 = P_1 + F_r_star_u*WPF_0
            P_10 = P_10 + F_r_star_u*WPF_1
            P_19 = P_19*(keep_w*keep_w) + disturbance_scale*w_nominal*(1.0 - (keep_w*keep_w))
            P_20 = P_20*keep_w
            P_21 = P_21*keep_w
            P_22 = P_22*keep_w
            P_23 = P_23*keep_w
            P_24 = P_24*keep_w
            P_25 = P_25*keep_w
            P_26 = P_26*keep_w
            ay_with_0 = P_9 + FP_0_0*ay_from_0 + FP_0_1*ay_from_1 + P_0*ay_to_0 + P_1*ay_to_1 + P_7*ay_by_7
            ay_with_1 = P_18 + FP_1_0*ay_from_0 + FP_1_1*ay_from_1 + P_1*ay_to_0 + P_10*ay_to_1 + P_16*ay_by_7
            ay_spread = ay_with_9 + ay_before_0*ay_from_0 + ay_before_1*ay_from_1 + ay_by_7*ay_with_7 + ay_to_0*ay_with_0 + ay_to_1*ay_with_1
            disturbance = disturbance*keep_w
            v_star = d_v_star + v_star
            r_star = d_r_star + r_star
        move = 0.0
        if excited <= 0.0:  # nothing heard: it may have changed
            lost = (1.0 if (1.0) < (0.5*dt*idle_drift*prior_information) else 0.5*dt*idle_drift*prior_information)
            keep = 1.0 - lost
            diffusion = lost*(1.0 + keep)/(dt*prior_information)  # for long: the prior variance
            P_3 = P_3*keep
            P_12 = P_12*keep
            P_20 = P_20*keep
            P_27 = P_27*keep
            P_28 = P_28*keep
            P_29 = P_29*keep
            P_30 = P_30*keep
            P_31 = P_31*keep
            P_32 = P_32*keep
            P_33 = P_33*keep
            P_27 = P_27*keep
            p = K - K_prior
            q = K + K_prior
            pp = (p*p)
            qq = (q*q)
            away = 2.0*p*(15.0*qq - 4.0*pp)/(q*(15.0*qq - 9.0*pp))  # ln(K/K_prior)
            move = (-away*lost)
            ay_with_3 = ay_with_3*keep
        else:
            diffusion = drift + faint_drift*(0.0 if (0.0) > (1.0 - heard*inv_telling) else 1.0 - heard*inv_telling)  # a jump that could not have shown may have come
        P_27 = P_27 + dt*(diffusion + jump*jump_drift)
        P_54 = P_54 + ay_bias_drift*dt
        P_52 = P_52 + bias_drift*dt
        response = output_scale*r_star  # output of the model
        predicted = output_bias + response
        output_rate = d_r_star*inv_dt*output_scale
        activity = activity + activity_rate*held*((response*response) - activity)
        noise = noise_scale*(noise_variance + (output_rate*output_rate)*(timing_error*timing_error) + 2.0*activity*inv_dt*structure_time*(structure_share*structure_share))  # variance of the measurement
        validity_now = inv_L*r_star*(at_U*at_U)  # lateral acceleration
        validity_then = validity*(1.0 - held*validity_rate)
        validity_square = (validity_now*validity_now)
        validity = (validity_square if (validity_square) > (validity_then) else validity_then)
        if usable > 0.5:  # measurement
            c_1 = P_17 + P_10*output_scale
            c_3 = P_32 + P_12*output_scale
            c_8 = P_52 + P_17*output_scale
            innovation = measured - predicted
            innovation_variance = c_8 + noise + c_1*output_scale
            inv_spread = (1.0/innovation_variance)
            nis = inv_spread*(innovation*innovation)  # normalised innovation squared
            if nis > outlier_ratio:  # an outlier counts for less
                inv_spread = inv_spread*outlier_ratio/nis
            odd = (9.0 if (9.0) < (nis) else nis) - 1.0  # by how much it is not as expected
            linear = 1.0  # 1 in the model's linear range
            if validity >= (validity_limit*validity_limit):
                linear = 0.0
                if status < 1.5:
                    status = 2.0
            surprise = surprise + held*surprise_rate*(1.0 + linear*odd - surprise)  # recent mean of the normalised innovation squared
            above = surprise - 1.0
            if (above*above) > jump_ratio*restlessness:
                jump = (0.0 if (0.0) > (surprise - surprise_limit) else surprise - surprise_limit)
            else:
                jump = 0.0
            inv_P = (1.0/P_27)
            sensitivity = c_3*inv_P  # of the output to ln K
            heard = heard*(1.0 - heard_rate*held) + inv_spread*(sensitivity*sensitivity)  # information of late
            if abs(ay_measured) < ay_limit:  # ay is measured too
                if (abs(last_ay) < ay_limit) and (anew < 0.5) and (dt <= longest):  # and was, a sample before
                    ay_response = inv_L*(at_U*at_U)*(r_star + d_v_star/h + d_r_star*lead/h - 0.5*d_r_star)  # mean ay of the model over the sample
                    ay_activity = ay_activity + activity_rate*held*((ay_response*ay_response) - ay_activity)
                    ay_both = ay_with_8 + ay_with_1*output_scale
                    ay_after = ay_both*inv_spread  # what the first output has said of it
                    ay_innovation = 0.5*ay_measured + 0.5*last_ay - ay_bias - ay_response - ay_after*innovation
                    ay_left = (0.0 if (0.0) > (ay_spread - ay_after*ay_both) else ay_spread - ay_after*ay_both)  # rounding may leave less than nothing
                    ay_inv_spread = (1.0/(ay_left + 2.0*ay_noise_scale*ay_time*inv_dt*(ay_variance + ay_activity*(ay_share*ay_share))))
                    ay_nis = ay_inv_spread*(ay_innovation*ay_innovation)  # normalised innovation squared
                    ay_odd = (9.0 if (9.0) < (ay_nis) else ay_nis) - 1.0  # by how much it is not as expected
                    if ay_nis > outlier_ratio:  # an outlier counts for less
                        ay_inv_spread = ay_inv_spread*outlier_ratio/ay_nis
                else:
                    ay_innovation = 0.0
                    ay_inv_spread = 0.0
                    ay_after = 0.0
                    ay_odd = 0.0
                last_ay = ay_measured
            else:
                ay_innovation = 0.0
                ay_inv_spread = 0.0
                ay_after = 0.0
                ay_odd = 0.0
                last_ay = 2.0*ay_limit
            ay_c_3 = ay_with_3 - ay_after*c_3
            if excited > 0.0:  # heard of the samples before
                learn_slow = (inv_spread if jump <= 0.0 else 0.0)  # a jump is not blamed on what cannot jump
                ay_learn_slow = (ay_inv_spread if jump <= 0.0 else 0.0)  # a jump is not blamed on what cannot jump
                unlearnt = dt + unlearnt
                learn_seldom = 0.0
                ay_learn_seldom = 0.0
                if unlearnt >= seldom:  # the next sample tells little that this one does not
                    learn_seldom = learn_slow
                    ay_learn_seldom = ay_learn_slow
                    unlearnt = 0.0
                gain_3 = c_3*inv_spread
                ay_gain_3 = ay_c_3*ay_inv_spread
                gained = inv_P*(ay_c_3*ay_gain_3 + c_3*gain_3)  # share of the variance removed
                information = information + gained*inv_P*(1.0 + gained)  # 1/variance gained
                move = move + ay_gain_3*ay_innovation + gain_3*innovation
                c_4 = P_38 + P_13*output_scale
                c_5 = P_43 + P_14*output_scale
                c_6 = P_47 + P_15*output_scale
                c_7 = P_50 + P_16*output_scale
                ay_c_4 = ay_with_4 - ay_after*c_4
                ay_c_5 = ay_with_5 - ay_after*c_5
                ay_c_6 = ay_with_6 - ay_after*c_6
                ay_c_7 = ay_with_7 - ay_after*c_7
                gain_4 = c_4*learn_seldom
                ay_gain_4 = ay_c_4*ay_learn_seldom
                gain_5 = c_5*learn_slow
                ay_gain_5 = ay_c_5*ay_learn_slow
                gain_6 = c_6*learn_slow
                ay_gain_6 = ay_c_6*ay_learn_slow
                P_27 = P_27 - ay_c_3*ay_gain_3 - c_3*gain_3
                P_28 = P_28 - ay_c_4*ay_gain_3 - c_4*gain_3
                P_29 = P_29 - ay_c_5*ay_gain_3 - c_5*gain_3
                P_30 = P_30 - ay_c_6*ay_gain_3 - c_6*gain_3
                P_31 = P_31 - ay_c_7*ay_gain_3 - c_7*gain_3
                P_34 = P_34 - ay_c_4*ay_gain_4 - c_4*gain_4
                P_35 = P_35 - ay_c_4*ay_gain_5 - c_4*gain_5
                P_36 = P_36 - ay_c_4*ay_gain_6 - c_4*gain_6
                P_37 = P_37 - ay_c_7*ay_gain_4 - c_7*gain_4
                P_40 = P_40 - ay_c_5*ay_gain_5 - c_5*gain_5
                P_41 = P_41 - ay_c_6*ay_gain_5 - c_6*gain_5
                P_42 = P_42 - ay_c_7*ay_gain_5 - c_7*gain_5
                P_45 = P_45 - ay_c_6*ay_gain_6 - c_6*gain_6
                P_46 = P_46 - ay_c_7*ay_gain_6 - c_7*gain_6
                pi1 = pi1 + ay_gain_4*ay_innovation + gain_4*innovation
                move_eta = ay_gain_5*ay_innovation + gain_5*innovation
                half_move_eta = 1.0 + move_eta*(0.5 + 0.125*move_eta)
                eta = eta*(half_move_eta*half_move_eta)
                move_rho = ay_gain_6*ay_innovation + gain_6*innovation
                half_move_rho = 1.0 + move_rho*(0.5 + 0.125*move_rho)
                rho = rho*(half_move_rho*half_move_rho)
                if pi1 < pi1_low:  # its allowed range
                    pi1 = pi1_low
                    status = 3.0
                if eta < eta_low:  # its allowed range
                    eta = eta_low
                    status = 3.0
                if rho < rho_low:  # its allowed range
                    rho = rho_low
                    status = 3.0
                if pi1 > pi1_high:  # its allowed range
                    pi1 = pi1_high
                    status = 3.0
                if eta > eta_high:  # its allowed range
                    eta = eta_high
                    status = 3.0
                if rho > rho_high:  # its allowed range
                    rho = rho_high
                    status = 3.0
            else:
                if status < 0.5:
                    status = 1.0
            c_0 = P_8 + P_1*output_scale
            c_2 = P_25 + P_11*output_scale
            c_4 = P_38 + P_13*output_scale
            c_5 = P_43 + P_14*output_scale
            c_6 = P_47 + P_15*output_scale
            c_7 = P_50 + P_16*output_scale
            c_9 = P_53 + P_18*output_scale
            ay_c_0 = ay_with_0 - ay_after*c_0
            ay_c_1 = ay_with_1 - ay_after*c_1
            ay_c_2 = ay_with_2 - ay_after*c_2
            ay_c_4 = ay_with_4 - ay_after*c_4
            ay_c_5 = ay_with_5 - ay_after*c_5
            ay_c_6 = ay_with_6 - ay_after*c_6
            ay_c_7 = ay_with_7 - ay_after*c_7
            ay_c_8 = ay_with_8 - ay_after*c_8
            ay_c_9 = ay_with_9 - ay_after*c_9
            gain_0 = c_0*inv_spread
            ay_gain_0 = ay_c_0*ay_inv_spread
            P_0 = P_0 - ay_c_0*ay_gain_0 - c_0*gain_0
            P_1 = P_1 - ay_c_1*ay_gain_0 - c_1*gain_0
            P_2 = P_2 - ay_c_2*ay_gain_0 - c_2*gain_0
            P_3 = P_3 - ay_c_3*ay_gain_0 - c_3*gain_0
            P_4 = P_4 - ay_c_4*ay_gain_0 - c_4*gain_0
            P_5 = P_5 - ay_c_5*ay_gain_0 - c_5*gain_0
            P_6 = P_6 - ay_c_6*ay_gain_0 - c_6*gain_0
            P_7 = P_7 - ay_c_7*ay_gain_0 - c_7*gain_0
            P_8 = P_8 - ay_c_8*ay_gain_0 - c_8*gain_0
            P_9 = P_9 - ay_c_9*ay_gain_0 - c_9*gain_0
            v_star = v_star + ay_gain_0*ay_innovation + gain_0*innovation
            gain_1 = c_1*inv_spread
            ay_gain_1 = ay_c_1*ay_inv_spread
            P_10 = P_10 - ay_c_1*ay_gain_1 - c_1*gain_1
            P_11 = P_11 - ay_c_2*ay_gain_1 - c_2*gain_1
            P_12 = P_12 - ay_c_3*ay_gain_1 - c_3*gain_1
            P_13 = P_13 - ay_c_4*ay_gain_1 - c_4*gain_1
            P_14 = P_14 - ay_c_5*ay_gain_1 - c_5*gain_1
            P_15 = P_15 - ay_c_6*ay_gain_1 - c_6*gain_1
            P_16 = P_16 - ay_c_7*ay_gain_1 - c_7*gain_1
            P_17 = P_17 - ay_c_8*ay_gain_1 - c_8*gain_1
            P_18 = P_18 - ay_c_9*ay_gain_1 - c_9*gain_1
            r_star = r_star + ay_gain_1*ay_innovation + gain_1*innovation
            gain_2 = c_2*inv_spread
            ay_gain_2 = ay_c_2*ay_inv_spread
            P_19 = P_19 - ay_c_2*ay_gain_2 - c_2*gain_2
            P_20 = P_20 - ay_c_3*ay_gain_2 - c_3*gain_2
            P_21 = P_21 - ay_c_4*ay_gain_2 - c_4*gain_2
            P_22 = P_22 - ay_c_5*ay_gain_2 - c_5*gain_2
            P_23 = P_23 - ay_c_6*ay_gain_2 - c_6*gain_2
            P_24 = P_24 - ay_c_7*ay_gain_2 - c_7*gain_2
            P_25 = P_25 - ay_c_8*ay_gain_2 - c_8*gain_2
            P_26 = P_26 - ay_c_9*ay_gain_2 - c_9*gain_2
            disturbance = disturbance + ay_gain_2*ay_innovation + gain_2*innovation
            gain_8 = c_8*inv_spread
            ay_gain_8 = ay_c_8*ay_inv_spread
            P_32 = P_32 - ay_c_3*ay_gain_8 - c_3*gain_8
            P_38 = P_38 - ay_c_4*ay_gain_8 - c_4*gain_8
            P_43 = P_43 - ay_c_5*ay_gain_8 - c_5*gain_8
            P_47 = P_47 - ay_c_6*ay_gain_8 - c_6*gain_8
            P_50 = P_50 - ay_c_7*ay_gain_8 - c_7*gain_8
            P_52 = P_52 - ay_c_8*ay_gain_8 - c_8*gain_8
            P_53 = P_53 - ay_c_9*ay_gain_8 - c_9*gain_8
            output_bias = output_bias + ay_gain_8*ay_innovation + gain_8*innovation
            gain_9 = c_9*inv_spread
            ay_gain_9 = ay_c_9*ay_inv_spread
            P_33 = P_33 - ay_c_3*ay_gain_9 - c_3*gain_9
            P_39 = P_39 - ay_c_4*ay_gain_9 - c_4*gain_9
            P_44 = P_44 - ay_c_5*ay_gain_9 - c_5*gain_9
            P_48 = P_48 - ay_c_6*ay_gain_9 - c_6*gain_9
            P_51 = P_51 - ay_c_7*ay_gain_9 - c_7*gain_9
            P_54 = P_54 - ay_c_9*ay_gain_9 - c_9*gain_9
            ay_bias = ay_bias + ay_gain_9*ay_innovation + gain_9*innovation
            if turn <= 0.0:  # one for three samples
                expected = disturbance_scale*w_nominal  # disturbance variance expected
                seen = (9.0*expected if (9.0*expected) < (P_19 + (disturbance*disturbance)) else P_19 + (disturbance*disturbance))  # and seen
                unseen = (expected*observed_least if (expected*observed_least) > (expected - P_19) else expected - P_19)
                disturbance_scale = disturbance_scale + 3.0*disturbance_adapt*disturbance_scale*held*(seen - expected)/unseen
                disturbance_scale = (disturbance_scale if (disturbance_scale) > (disturbance_scale_low) else disturbance_scale_low)
                disturbance_scale = (disturbance_scale if (disturbance_scale) < (disturbance_scale_high) else disturbance_scale_high)
                turn = 1.0
            else:
                if turn < 1.5:
                    settling = (noise_adapt if (noise_adapt) > (settling - 3.0*dt*(settling*settling)) else settling - 3.0*dt*(settling*settling))  # 1/time at first
                    noise_change = odd*(0.05 if (0.05) < (3.0*dt*settling) else 3.0*dt*settling)
                    noise_scale = noise_scale*(1.0 + noise_change*(1.0 + 0.5*noise_change))
                    noise_scale = (noise_scale if (noise_scale) > (noise_scale_low) else noise_scale_low)
                    noise_scale = (noise_scale if (noise_scale) < (noise_scale_high) else noise_scale_high)
                    turn = 2.0
                else:
                    restlessness = restlessness + 3.0*held*noise_adapt*((above*above) - restlessness)
                    excitation = excitation + 3.0*excitation_rate*held*((sensitivity*sensitivity) - excitation)
                    excited = (1.0 if excitation > excitation_ratio*noise else 0.0)
                    ay_noise_change = ay_odd*(0.05 if (0.05) < (3.0*dt*settling) else 3.0*dt*settling)
                    ay_noise_scale = ay_noise_scale*(1.0 + ay_noise_change*(1.0 + 0.5*ay_noise_change))
                    ay_noise_scale = (ay_noise_scale if (ay_noise_scale) > (ay_noise_scale_low) else ay_noise_scale_low)
                    ay_noise_scale = (ay_noise_scale if (ay_noise_scale) < (ay_noise_scale_high) else ay_noise_scale_high)
                    turn = 0.0
        else:
            innovation = 0.0
            innovation_variance = noise_scale*noise_variance
            last_ay = 2.0*ay_limit
        half_move = 1.0 + move*(0.5 + 0.125*move)
        K = K*(half_move*half_move)
        last_input = u_now
        last_U = at_U
        if usable > 0.5:
            age = 0.0
            started = 1.0
            if K < K_low:  # its allowed range
                K = K_low
                status = 3.0
            if K > K_high:  # its allowed range
                K = K_high
                status = 3.0
    else:
        status = 7.0
        age = (1000000.0 if dt > 1.0 else age)  # an endless pause is a gap for the next sample
        innovation = 0.0
        innovation_variance = noise_scale*noise_variance
    estimate = K
    variance = P_27
    information_gained = information
    state[:] = [v_star, r_star, disturbance, K, pi1, eta, rho, lead, output_bias, ay_with_0, ay_with_1, ay_with_2, ay_with_3, ay_with_4, ay_with_5, ay_with_6, ay_with_7, ay_with_8, ay_with_9, ay_spread, last_ay, ay_bias, ay_activity, ay_noise_scale, P_0, P_1, P_2, P_3, P_4, P_5, P_6, P_7, P_8, P_9, P_10, P_11, P_12, P_13, P_14, P_15, P_16, P_17, P_18, P_19, P_20, P_21, P_22, P_23, P_24, P_25, P_26, P_27, P_28, P_29, P_30, P_31, P_32, P_33, P_34, P_35, P_36, P_37, P_38, P_39, P_40, P_41, P_42, P_43, P_44, P_45, P_46, P_47, P_48, P_49, P_50, P_51, P_52, P_53, P_54, noise_scale, disturbance_scale, activity, settling, restlessness, jump, surprise, heard, excitation, excited, unlearnt, validity, information, last_input, last_U, age, turn, started]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance, information_gained]
