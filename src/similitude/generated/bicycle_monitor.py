"""Change alarm of the bicycle: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle, Brennan & Alleyne 2004, eqs 1-4
base: m, L, U
follows: K; held: K, pi1, eta, rho

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_monitor'
OPERATIONS = 1156
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ()
REPORTS = False  # outputs are worked out when they are asked for, by a function of their own

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('v_star_sd', '-', 'sd after a restart', 1),
    ('r_star_sd', '-', 'sd after a restart', 1),
    ('disturbance_rate', '1/s', '1/correlation time of the disturbance', 1),
    ('companion_rate', '1/s', 'rate at which the drives along the input follow the held filter', 1),
    ('threshold_fall', '-', 'evidence that rings for a fall', 1),
    ('threshold_rise', '-', 'evidence that rings for a rise', 1),
    ('evidence_floor', '-', 'evidence against a change at which it is supposed to begin anew', 1),
    ('evidence_leak', '1/s', 'rate at which evidence is forgotten', 1),
    ('age_most', 's', 'longest time one supposed change is followed', 1),
    ('gain_rate', '1/s', 'averaging rate of the evidence gained', 1),
    ('gain_most', '1/s', 'most evidence gained in a second', 1),
    ('piece_most', '-', 'evidence from one half-wave of the signature that counts in full', 1),
    ('piece_share', '-', 'what counts of the rest where the change explains the drive', 1),
    ('piece_fit', '-', 'most of what the reference leaves that a change may leave, for that', 1),
    ('size_least', '-', 'least change of ln K that is looked for', 1),
    ('size_most', '-', 'greatest change of ln K that is looked for', 1),
    ('size_large', '-', 'change of ln K that needs no more evidence than the threshold', 1),
    ('small_price', '-', 'further evidence a smaller one needs, for each unit of the difference', 1),
    ('size_guess', '-', 'change of ln K supposed at first', 1),
    ('size_weight', '-', 'information the first guess is worth', 1),
    ('outlier_ratio', '-', 'squared innovation over its variance beyond which it is bounded', 1),
    ('smooth_rate', '1/s', "averaging rate of the innovations' slow part", 1),
    ('rough_rate', '1/s', "averaging rate of that part's mean square", 1),
    ('rough_free', '-', 'mean square against white noise up to which evidence comes fast', 1),
    ('rough_share', '-', 'most of what the reference leaves that a change may leave', 1),
    ('score_rate', '1/s', 'averaging rate of the score', 1),
    ('distrust_rate', '1/s', 'averaging rate of the squared score against its variance', 1),
    ('distrust_share', '-', 'how much of that is held against the evidence', 1),
    ('sizes_squared', '-', "least squared size of a change over the reference's variance", 1),
    ('reference_rate', '1/s', 'rate at which the reference follows the estimate', 1),
    ('known_least', '-', 'information about ln K before the monitor is armed', 1),
    ('variance_most', '-', 'variance of ln K with which the monitor can be armed', 1),
    ('heard_least', 's', 'time of sure listening before the monitor is armed', 1),
    ('heard_spare', 's', 'most such time kept beyond that', 1),
    ('heard_again', 's', 'such time after an alarm before the next', 1),
    ('hearing_rate', '1/s', 'averaging rate of the information heard a second', 1),
    ('hearing_least', '1/s', 'information about ln K a second below which nothing is judged', 1),
    ('input_limit', 'rad', 'greatest believable delta', 1),
    ('output_limit', 'rad/s', 'greatest believable r', 1),
    ('signal_limit', 'm/s', 'greatest believable scale', 1),
    ('validity_limit', 'm/s^2', 'beyond it nothing is judged', 1),
    ('validity_rate', '1/s', 'decay rate of the memory of a visit beyond it', 1),
)

STATE = (
    ('v_star_held', '-', 'dynamic state of the held filter', 1),
    ('r_star_held', '-', 'dynamic state of the held filter', 1),
    ('disturbance_held', 'rad', 'disturbance of the held filter', 1),
    ('P', '-', 'covariance of the above, upper triangle by rows', 6),
    ('v_star_plain', '-', 'state along the steer alone', 1),
    ('r_star_plain', '-', 'state along the steer alone', 1),
    ('v_star_fall', '-', 'the same after a fall', 1),
    ('r_star_fall', '-', 'the same after a fall', 1),
    ('v_star_miss_fall', '-', "the held filter's error after a fall", 1),
    ('r_star_miss_fall', '-', "the held filter's error after a fall", 1),
    ('disturbance_miss_fall', '-', "the held filter's error after a fall", 1),
    ('v_star_rise', '-', 'the same after a rise', 1),
    ('r_star_rise', '-', 'the same after a rise', 1),
    ('v_star_miss_rise', '-', "the held filter's error after a rise", 1),
    ('r_star_miss_rise', '-', "the held filter's error after a rise", 1),
    ('disturbance_miss_rise', '-', "the held filter's error after a rise", 1),
    ('K_held', 'm^2/s^2', 'reference of Caf L/m, front cornering stiffness per mass and length', 1),
    ('pi1_held', '-', 'reference of a/L, position of the centre of gravity', 1),
    ('eta_held', '-', 'reference of rear over front cornering coefficient; > 1 understeers', 1),
    ('rho_held', '-', 'reference of Iz/(m a b), yaw inertia ratio', 1),
    ('input_offset_held', 'rad', 'reference of the offset of delta', 1),
    ('output_bias_held', 'rad/s', 'reference of the bias of r', 1),
    ('variance_held', '-', 'variance that ln K has in the reference', 1),
    ('size_fall', '-', 'fall: logarithm of the supposed change', 1),
    ('evidence_fall', '-', 'fall: log likelihood for it over the reference', 1),
    ('age_fall', 's', 'fall: time since it is supposed', 1),
    ('weight_sum_fall', '-', 'fall: information about its size', 1),
    ('score_sum_fall', '-', 'fall: information times size', 1),
    ('lately_fall', '-', 'fall: recent mean of the evidence gained', 1),
    ('side_fall', 'rad/s', "fall: signature's side of zero", 1),
    ('piece_fall', '-', 'fall: evidence from this half-wave', 1),
    ('size_rise', '-', 'rise: logarithm of the supposed change', 1),
    ('evidence_rise', '-', 'rise: log likelihood for it over the reference', 1),
    ('age_rise', 's', 'rise: time since it is supposed', 1),
    ('weight_sum_rise', '-', 'rise: information about its size', 1),
    ('score_sum_rise', '-', 'rise: information times size', 1),
    ('lately_rise', '-', 'rise: recent mean of the evidence gained', 1),
    ('side_rise', 'rad/s', "rise: signature's side of zero", 1),
    ('piece_rise', '-', 'rise: evidence from this half-wave', 1),
    ('smooth_same', 'rad/s', 'slow part of what is left, same', 1),
    ('smooth_fall', 'rad/s', 'slow part of what is left, fall', 1),
    ('smooth_rise', 'rad/s', 'slow part of what is left, rise', 1),
    ('rough_same', '-', 'its mean square against white noise, same', 1),
    ('rough_fall', '-', 'its mean square against white noise, fall', 1),
    ('rough_rise', '-', 'its mean square against white noise, rise', 1),
    ('score', '-', 'recent score of the reference', 1),
    ('score_variance', '-', 'its variance were the innovations white', 1),
    ('distrust', '-', 'long-run mean of the squared score over that variance', 1),
    ('known', '-', 'information about the first unknown, the others given', 1),
    ('hearing', '1/s', 'the same a second', 1),
    ('heard', 's', 'time of sure listening', 1),
    ('validity', '(m/s^2)^2', 'recent peak, squared', 1),
    ('last_input', 'rad', 'input of the sample before', 1),
    ('last_U', 'm/s', 'forward speed of the sample before', 1),
    ('started', '-', '1 once a sample was seen', 1),
)

SAMPLE = (
    ('dt', 's', 'time since the sample before', 1),
    ('input', 'rad', 'road-wheel steer angle', 1),
    ('U', 'm/s', 'forward speed', 1),
    ('measured', 'rad/s', 'measured yaw rate', 1),
    ('code', '-', "status of the filter's step", 1),
    ('estimate', 'm^2/s^2', 'Caf L/m, front cornering stiffness per mass and length', 1),
    ('own_variance', '-', 'variance of ln K that the filter goes by', 1),
    ('pi1_now', '-', 'a/L, position of the centre of gravity', 1),
    ('eta_now', '-', 'rear over front cornering coefficient; > 1 understeers', 1),
    ('rho_now', '-', 'Iz/(m a b), yaw inertia ratio', 1),
    ('offset_now', 'rad', 'offset of delta', 1),
    ('bias_now', 'rad/s', 'bias of r', 1),
    ('noise_now', '(rad/s)^2', 'variance of the measurement', 1),
    ('disturbance_now', '(rad)^2', 'variance of the disturbance in the long run', 1),
)

OUTPUT = (
    ('alarm', '-', '0, or 1 where a fall and 2 where a rise is found at this sample', 1),
    ('onset_age', 's', 'how long ago it began', 1),
    ('change', '-', 'change of ln K', 1),
    ('change_variance', '-', 'its variance', 1),
    ('reference', 'm^2/s^2', 'what K was before, as the monitor follows it', 1),
    ('evidence_of_fall', '-', 'log likelihood of a fall, less what its smallness costs', 1),
    ('evidence_of_rise', '-', 'log likelihood of a rise, less what its smallness costs', 1),
    ('armed', '-', '1 where a change would be found now', 1),
    ('information_rate', '1/s', 'information about ln K a second, the others given', 1),
)


def init(config):
    """The flat state before the first sample, from the flat configuration."""
    v_star_held = 0.0
    r_star_held = 0.0
    disturbance_held = 0.0
    P_0 = 0.0
    P_1 = 0.0
    P_2 = 0.0
    P_3 = 0.0
    P_4 = 0.0
    P_5 = 0.0
    v_star_plain = 0.0
    r_star_plain = 0.0
    v_star_fall = 0.0
    r_star_fall = 0.0
    v_star_miss_fall = 0.0
    r_star_miss_fall = 0.0
    disturbance_miss_fall = 0.0
    v_star_rise = 0.0
    r_star_rise = 0.0
    v_star_miss_rise = 0.0
    r_star_miss_rise = 0.0
    disturbance_miss_rise = 0.0
    K_held = 0.0
    pi1_held = 0.0
    eta_held = 0.0
    rho_held = 0.0
    input_offset_held = 0.0
    output_bias_held = 0.0
    variance_held = 0.0
    size_fall = 0.0
    evidence_fall = 0.0
    age_fall = 0.0
    weight_sum_fall = 0.0
    score_sum_fall = 0.0
    lately_fall = 0.0
    side_fall = 0.0
    piece_fall = 0.0
    size_rise = 0.0
    evidence_rise = 0.0
    age_rise = 0.0
    weight_sum_rise = 0.0
    score_sum_rise = 0.0
    lately_rise = 0.0
    side_rise = 0.0
    piece_rise = 0.0
    smooth_same = 0.0
    smooth_fall = 0.0
    smooth_rise = 0.0
    rough_same = 1.0
    rough_fall = 1.0
    rough_rise = 1.0
    score = 0.0
    score_variance = 0.0
    distrust = 1.0
    known = 0.0
    hearing = 0.0
    heard = 0.0
    validity = 0.0
    last_input = 0.0
    last_U = 0.0
    started = 0.0
    return [v_star_held, r_star_held, disturbance_held, P_0, P_1, P_2, P_3, P_4, P_5, v_star_plain, r_star_plain, v_star_fall, r_star_fall, v_star_miss_fall, r_star_miss_fall, disturbance_miss_fall, v_star_rise, r_star_rise, v_star_miss_rise, r_star_miss_rise, disturbance_miss_rise, K_held, pi1_held, eta_held, rho_held, input_offset_held, output_bias_held, variance_held, size_fall, evidence_fall, age_fall, weight_sum_fall, score_sum_fall, lately_fall, side_fall, piece_fall, size_rise, evidence_rise, age_rise, weight_sum_rise, score_sum_rise, lately_rise, side_rise, piece_rise, smooth_same, smooth_fall, smooth_rise, rough_same, rough_fall, rough_rise, score, score_variance, distrust, known, hearing, heard, validity, last_input, last_U, started]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    L = config[0]
    v_star_sd = config[1]
    r_star_sd = config[2]
    disturbance_rate = config[3]
    companion_rate = config[4]
    threshold_fall = config[5]
    threshold_rise = config[6]
    evidence_floor = config[7]
    evidence_leak = config[8]
    age_most = config[9]
    gain_rate = config[10]
    gain_most = config[11]
    piece_most = config[12]
    piece_share = config[13]
    piece_fit = config[14]
    size_least = config[15]
    size_most = config[16]
    size_large = config[17]
    small_price = config[18]
    size_guess = config[19]
    size_weight = config[20]
    outlier_ratio = config[21]
    smooth_rate = config[22]
    rough_rate = config[23]
    rough_free = config[24]
    rough_share = config[25]
    score_rate = config[26]
    distrust_rate = config[27]
    distrust_share = config[28]
    sizes_squared = config[29]
    reference_rate = config[30]
    known_least = config[31]
    variance_most = config[32]
    heard_least = config[33]
    heard_spare = config[34]
    heard_again = config[35]
    hearing_rate = config[36]
    hearing_least = config[37]
    input_limit = config[38]
    output_limit = config[39]
    signal_limit = config[40]
    validity_limit = config[41]
    validity_rate = config[42]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    code = sample[4]
    estimate = sample[5]
    own_variance = sample[6]
    pi1_now = sample[7]
    eta_now = sample[8]
    rho_now = sample[9]
    offset_now = sample[10]
    bias_now = sample[11]
    noise_now = sample[12]
    disturbance_now = sample[13]
    v_star_held = state[0]
    r_star_held = state[1]
    disturbance_held = state[2]
    P_0 = state[3]
    P_1 = state[4]
    P_2 = state[5]
    P_3 = state[6]
    P_4 = state[7]
    P_5 = state[8]
    v_star_plain = state[9]
    r_star_plain = state[10]
    v_star_fall = state[11]
    r_star_fall = state[12]
    v_star_miss_fall = state[13]
    r_star_miss_fall = state[14]
    disturbance_miss_fall = state[15]
    v_star_rise = state[16]
    r_star_rise = state[17]
    v_star_miss_rise = state[18]
    r_star_miss_rise = state[19]
    disturbance_miss_rise = state[20]
    K_held = state[21]
    pi1_held = state[22]
    eta_held = state[23]
    rho_held = state[24]
    input_offset_held = state[25]
    output_bias_held = state[26]
    variance_held = state[27]
    size_fall = state[28]
    evidence_fall = state[29]
    age_fall = state[30]
    weight_sum_fall = state[31]
    score_sum_fall = state[32]
    lately_fall = state[33]
    side_fall = state[34]
    piece_fall = state[35]
    size_rise = state[36]
    evidence_rise = state[37]
    age_rise = state[38]
    weight_sum_rise = state[39]
    score_sum_rise = state[40]
    lately_rise = state[41]
    side_rise = state[42]
    piece_rise = state[43]
    smooth_same = state[44]
    smooth_fall = state[45]
    smooth_rise = state[46]
    rough_same = state[47]
    rough_fall = state[48]
    rough_rise = state[49]
    score = state[50]
    score_variance = state[51]
    distrust = state[52]
    known = state[53]
    hearing = state[54]
    heard = state[55]
    validity = state[56]
    last_input = state[57]
    last_U = state[58]
    started = state[59]
    U_used = 0.0
    alarm = 0.0
    anew = 0.0
    armed = 0.0
    change = 0.0
    change_variance = 0.0
    evidence_of_fall = 0.0
    evidence_of_rise = 0.0
    information_rate = 0.0
    onset_age = 0.0
    reference = 0.0
    status = 0.0
    u_now = 0.0
    usable = 0.0
    status = 0.0
    alarm = 0.0
    onset_age = 0.0
    change = 0.0
    change_variance = 0.0
    if (dt < 1000000.0) and (dt > 1e-06):  # time must advance
        if (input < input_limit) and (input > (-input_limit)):  # missing: held
            u_now = input
        else:
            u_now = last_input
        if (U < signal_limit) and (U > (-signal_limit)):  # missing: held
            U_used = U
        else:
            U_used = last_U
        usable = (1.0 if (code < 3.5) and (measured < output_limit) and (measured > (-output_limit)) else 0.0)
        anew = (1.0 if ((code < 5.5) and (code > 4.5)) or ((code < 6.5) and (code > 5.5)) or (started < 0.5) else 0.0)
        started = 1.0
        if anew > 0.5:  # nothing is known of the dynamics
            v_star_held = 0.0
            r_star_held = 0.0
            disturbance_held = 0.0
            v_star_plain = 0.0
            r_star_plain = 0.0
            v_star_fall = 0.0
            r_star_fall = 0.0
            v_star_miss_fall = 0.0
            r_star_miss_fall = 0.0
            disturbance_miss_fall = 0.0
            v_star_rise = 0.0
            r_star_rise = 0.0
            v_star_miss_rise = 0.0
            r_star_miss_rise = 0.0
            disturbance_miss_rise = 0.0
            P_1 = 0.0
            P_2 = 0.0
            P_4 = 0.0
            P_0 = (v_star_sd*v_star_sd)
            P_3 = (r_star_sd*r_star_sd)
            P_5 = disturbance_now
            last_input = u_now
            last_U = U_used
            evidence_fall = 0.0
            age_fall = 0.0
            weight_sum_fall = 0.0
            score_sum_fall = 0.0
            lately_fall = 0.0
            side_fall = 0.0
            piece_fall = 0.0
            v_star_fall = v_star_plain
            r_star_fall = r_star_plain
            smooth_fall = smooth_same
            rough_fall = rough_same
            v_star_miss_fall = 0.0
            r_star_miss_fall = 0.0
            disturbance_miss_fall = 0.0
            evidence_rise = 0.0
            age_rise = 0.0
            weight_sum_rise = 0.0
            score_sum_rise = 0.0
            lately_rise = 0.0
            side_rise = 0.0
            piece_rise = 0.0
            v_star_rise = v_star_plain
            r_star_rise = r_star_plain
            smooth_rise = smooth_same
            rough_rise = rough_same
            v_star_miss_rise = 0.0
            r_star_miss_rise = 0.0
            disturbance_miss_rise = 0.0
        follow = (1.0 if not ((heard > heard_least) and (known > known_least)) else ((1.0 if (1.0) < (dt*reference_rate) else dt*reference_rate) if (code < 0.5) and (code > (-0.5)) and (hearing > hearing_least) else 0.0))
        K_held = K_held + follow*(estimate - K_held)
        pi1_held = pi1_held + follow*(pi1_now - pi1_held)
        eta_held = eta_held + follow*(eta_now - eta_held)
        rho_held = rho_held + follow*(rho_now - rho_held)
        input_offset_held = input_offset_held + follow*(offset_now - input_offset_held)
        output_bias_held = output_bias_held + follow*(bias_now - output_bias_held)
        variance_held = variance_held + follow*(own_variance - variance_held)
        size_fall = (-(size_most if (size_most) < ((size_least if (size_least) > ((size_guess*size_weight - score_sum_fall)/(size_weight + weight_sum_fall)) else (size_guess*size_weight - score_sum_fall)/(size_weight + weight_sum_fall))) else (size_least if (size_least) > ((size_guess*size_weight - score_sum_fall)/(size_weight + weight_sum_fall)) else (size_guess*size_weight - score_sum_fall)/(size_weight + weight_sum_fall))))
        K_fall = K_held*(12.0 + size_fall*(6.0 + size_fall))/((12.0 + size_fall*(size_fall - 6.0)))  # exp by its Pade approximant, good to 0.1 % for a fall by a factor of three
        size_rise = (size_most if (size_most) < ((size_least if (size_least) > ((score_sum_rise + size_guess*size_weight)/(size_weight + weight_sum_rise)) else (score_sum_rise + size_guess*size_weight)/(size_weight + weight_sum_rise))) else (size_least if (size_least) > ((score_sum_rise + size_guess*size_weight)/(size_weight + weight_sum_rise)) else (score_sum_rise + size_guess*size_weight)/(size_weight + weight_sum_rise)))
        K_rise = K_held*(12.0 + size_rise*(6.0 + size_rise))/((12.0 + size_rise*(size_rise - 6.0)))  # exp by its Pade approximant, good to 0.1 % for a rise by a factor of three
        least_scale = 0.0003333333333333333*signal_limit
        at_U = (U_used if (U_used) > (least_scale) else least_scale)  # kept off zero
        was_U = (last_U if (last_U) > (least_scale) else least_scale)
        inv_U = (1.0/at_U)
        inv_L = (1.0/L)
        output_scale = at_U*inv_L
        h = at_U*inv_L*(1.0 if (1.0) < (dt) else dt)  # dimensionless step
        steer = 0.5*last_input + 0.5*u_now  # mean of the sample's two ends
        steer_change = u_now - last_input
        keep_w = (0.0 if (0.0) > (1.0 - disturbance_rate*dt) else 1.0 - disturbance_rate*dt)
        ratio_v_star = inv_U*was_U  # same physical state in the new scales
        ratio_r_star = inv_U*was_U  # same physical state in the new scales
        v_star_held = ratio_v_star*v_star_held
        r_star_held = r_star_held*ratio_r_star
        v_star_plain = ratio_v_star*v_star_plain
        r_star_plain = r_star_plain*ratio_r_star
        v_star_fall = ratio_v_star*v_star_fall
        r_star_fall = r_star_fall*ratio_r_star
        v_star_rise = ratio_v_star*v_star_rise
        r_star_rise = r_star_rise*ratio_r_star
        v_star_miss_fall = ratio_v_star*v_star_miss_fall
        r_star_miss_fall = r_star_miss_fall*ratio_r_star
        v_star_miss_rise = ratio_v_star*v_star_miss_rise
        r_star_miss_rise = r_star_miss_rise*ratio_r_star
        u_plain = input_offset_held + steer  # the steer alone [-]
        u_held = disturbance_held + u_plain
        inv0 = (1.0/rho_held)
        inv1 = (1.0/(pi1_held - 1.0))
        c0 = (-r_star_held)
        c1 = pi1_held*r_star_held
        c2 = eta_held*(c0 + c1 + v_star_held)
        c3 = inv1*pi1_held
        c4 = u_held - c1 - v_star_held
        c5 = K_held*(inv_U*inv_U)
        c6 = c5*inv0
        c7 = c6*inv1
        c8 = (-r_star_plain)
        c9 = pi1_held*r_star_plain
        c10 = eta_held*(c8 + c9 + v_star_plain)
        c11 = u_plain - c9 - v_star_plain
        c12 = 0.16666666666666666*h
        c13 = eta_held - 1.0
        f_v_star_held = c0 + c5*(c4 + c2*c3)  # rate [-]
        f_r_star_held = c7*((-c2) - c4)  # rate [-]
        f_v_star_plain = c8 + c5*(c11 + c10*c3)
        f_r_star_plain = c7*((-c10) - c11)
        J_00 = c12*c5*(c3*eta_held - 1.0)
        J_01 = c12*(c13*c5*pi1_held - 1.0)
        J_10 = (-c12*c13*c7)
        J_11 = c12*c6*(inv1*pi1_held - eta_held)
        f_v_star_held_u_held = c5
        f_r_star_held_u_held = (-c7)
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
        slope1_v_star_held = J_00*f_v_star_held_u_held + J_01*f_r_star_held_u_held
        slope1_r_star_held = J_10*f_v_star_held_u_held + J_11*f_r_star_held_u_held
        rise_v_star_held = f_v_star_held_u_held*ramp_0 + ramp_1*slope1_v_star_held  # the input rises or falls in a straight line [-]
        rise_r_star_held = f_r_star_held_u_held*ramp_0 + ramp_1*slope1_r_star_held
        d_v_star_held = rise_v_star_held + G_00*f_v_star_held + G_01*f_r_star_held  # change over the step [-]
        d_r_star_held = rise_r_star_held + G_10*f_v_star_held + G_11*f_r_star_held  # change over the step [-]
        d_v_star_plain = rise_v_star_held + G_00*f_v_star_plain + G_01*f_r_star_plain
        d_r_star_plain = rise_r_star_held + G_10*f_v_star_plain + G_11*f_r_star_plain
        F_v_star_held_u_held = G_00*f_v_star_held_u_held + G_01*f_r_star_held_u_held
        F_r_star_held_u_held = G_10*f_v_star_held_u_held + G_11*f_r_star_held_u_held
        PW_0 = P_2
        FP_0_0 = F_v_star_held_u_held*PW_0 + M_00*P_0*ratio_v_star + M_01*P_1*ratio_r_star
        FP_1_0 = F_r_star_held_u_held*PW_0 + M_10*P_0*ratio_v_star + M_11*P_1*ratio_r_star
        PW_1 = P_4
        FP_0_1 = F_v_star_held_u_held*PW_1 + M_00*P_1*ratio_v_star + M_01*P_3*ratio_r_star
        FP_1_1 = F_r_star_held_u_held*PW_1 + M_10*P_1*ratio_v_star + M_11*P_3*ratio_r_star
        P_0 = FP_0_0*M_00*ratio_v_star + FP_0_1*M_01*ratio_r_star
        P_1 = FP_0_0*M_10*ratio_v_star + FP_0_1*M_11*ratio_r_star
        P_3 = FP_1_0*M_10*ratio_v_star + FP_1_1*M_11*ratio_r_star
        PW_2 = P_5
        FP_0_2 = F_v_star_held_u_held*PW_2 + M_00*P_2*ratio_v_star + M_01*P_4*ratio_r_star
        FP_1_2 = F_r_star_held_u_held*PW_2 + M_10*P_2*ratio_v_star + M_11*P_4*ratio_r_star
        P_2 = FP_0_2*keep_w
        P_4 = FP_1_2*keep_w
        WPF_0 = FP_0_2
        WPF_1 = FP_1_2
        P_0 = P_0 + F_v_star_held_u_held*WPF_0
        P_1 = P_1 + F_r_star_held_u_held*WPF_0
        P_3 = P_3 + F_r_star_held_u_held*WPF_1
        P_5 = P_5*(keep_w*keep_w) + disturbance_now*(1.0 - (keep_w*keep_w))
        v_star_held = d_v_star_held + v_star_held
        r_star_held = d_r_star_held + r_star_held
        v_star_plain = d_v_star_plain + v_star_plain
        r_star_plain = d_r_star_plain + r_star_plain
        disturbance_held = disturbance_held*keep_w
        new0_fall = F_v_star_held_u_held*disturbance_miss_fall + M_00*v_star_miss_fall + M_01*r_star_miss_fall
        new1_fall = F_r_star_held_u_held*disturbance_miss_fall + M_10*v_star_miss_fall + M_11*r_star_miss_fall
        v_star_miss_fall = new0_fall
        r_star_miss_fall = new1_fall
        disturbance_miss_fall = disturbance_miss_fall*keep_w
        new0_rise = F_v_star_held_u_held*disturbance_miss_rise + M_00*v_star_miss_rise + M_01*r_star_miss_rise
        new1_rise = F_r_star_held_u_held*disturbance_miss_rise + M_10*v_star_miss_rise + M_11*r_star_miss_rise
        v_star_miss_rise = new0_rise
        r_star_miss_rise = new1_rise
        disturbance_miss_rise = disturbance_miss_rise*keep_w
        inv0_fall = (1.0/rho_held)
        inv1_fall = (1.0/(pi1_held - 1.0))
        c0_fall = (-r_star_fall)
        c1_fall = pi1_held*r_star_fall
        c2_fall = eta_held*(c0_fall + c1_fall + v_star_fall)
        c3_fall = inv1_fall*pi1_held
        c4_fall = u_plain - c1_fall - v_star_fall
        c5_fall = K_fall*(inv_U*inv_U)
        c6_fall = c5_fall*inv0_fall
        c7_fall = c6_fall*inv1_fall
        c8_fall = 0.16666666666666666*h
        c9_fall = eta_held - 1.0
        f_v_star_fall_fall = c0_fall + c5_fall*(c4_fall + c2_fall*c3_fall)  # rate [-]
        f_r_star_fall_fall = c7_fall*((-c2_fall) - c4_fall)  # rate [-]
        J_00_fall = c5_fall*c8_fall*(c3_fall*eta_held - 1.0)
        J_01_fall = c8_fall*(c5_fall*c9_fall*pi1_held - 1.0)
        J_10_fall = (-c7_fall*c8_fall*c9_fall)
        J_11_fall = c6_fall*c8_fall*(inv1_fall*pi1_held - eta_held)
        f_v_star_fall_u_plain_fall = c5_fall
        f_r_star_fall_u_plain_fall = (-c7_fall)
        p0_fall = J_00_fall*J_11_fall - J_01_fall*J_10_fall
        p1_fall = (-J_00_fall) - J_11_fall
        n0_fall = 1.0 - 1.5*p0_fall
        n1_fall = (-2.0) - 1.5*p1_fall
        i_det_fall = (1.0/((n0_fall*n0_fall) + p0_fall*(n1_fall*n1_fall) - n0_fall*n1_fall*p1_fall))  # det N > 0 for every real J
        i0_fall = i_det_fall*(n0_fall - n1_fall*p1_fall)
        i1_fall = (-i_det_fall*n1_fall)
        E0_fall = i0_fall - i1_fall*p0_fall  # half a step
        E1_fall = i0_fall + i1_fall - i1_fall*p1_fall
        H0_fall = 0.5*h*i0_fall + 0.25*h*i1_fall*p0_fall  # change per rate over half a step
        H1_fall = 0.5*h*i1_fall + 0.25*h*i1_fall*p1_fall - 0.25*h*i0_fall
        g0_fall = H0_fall*(1.0 + E0_fall) - E1_fall*H1_fall*p0_fall
        g1_fall = E1_fall*H0_fall + H1_fall*(1.0 + E0_fall) - E1_fall*H1_fall*p1_fall
        wi0_fall = (-p0_fall*(0.4375 + 0.1875*p1_fall))
        wi1_fall = 0.1875*p0_fall - 0.5 - p1_fall*(0.4375 + 0.1875*p1_fall)
        wh0_fall = i0_fall*wi0_fall - i1_fall*p0_fall*wi1_fall
        wh1_fall = i0_fall*wi1_fall + i1_fall*wi0_fall - i1_fall*p1_fall*wi1_fall
        w0_fall = i0_fall*wh0_fall - i1_fall*p0_fall*wh1_fall  # W/h in powers of J
        w1_fall = i0_fall*wh1_fall + i1_fall*wh0_fall - i1_fall*p1_fall*wh1_fall
        G_00_fall = g0_fall + J_00_fall*g1_fall  # change per rate
        G_01_fall = J_01_fall*g1_fall
        G_10_fall = J_10_fall*g1_fall
        G_11_fall = g0_fall + J_11_fall*g1_fall
        ramp_fall = h*steer_change
        ramp_0_fall = ramp_fall*w0_fall
        ramp_1_fall = ramp_fall*w1_fall
        slope1_v_star_fall_fall = J_00_fall*f_v_star_fall_u_plain_fall + J_01_fall*f_r_star_fall_u_plain_fall
        slope1_r_star_fall_fall = J_10_fall*f_v_star_fall_u_plain_fall + J_11_fall*f_r_star_fall_u_plain_fall
        rise_v_star_fall_fall = f_v_star_fall_u_plain_fall*ramp_0_fall + ramp_1_fall*slope1_v_star_fall_fall  # the input rises or falls in a straight line [-]
        rise_r_star_fall_fall = f_r_star_fall_u_plain_fall*ramp_0_fall + ramp_1_fall*slope1_r_star_fall_fall
        d_v_star_fall_fall = rise_v_star_fall_fall + G_00_fall*f_v_star_fall_fall + G_01_fall*f_r_star_fall_fall  # change over the step [-]
        d_r_star_fall_fall = rise_r_star_fall_fall + G_10_fall*f_v_star_fall_fall + G_11_fall*f_r_star_fall_fall  # change over the step [-]
        v_star_fall = d_v_star_fall_fall + v_star_fall
        r_star_fall = d_r_star_fall_fall + r_star_fall
        inv0_rise = (1.0/rho_held)
        inv1_rise = (1.0/(pi1_held - 1.0))
        c0_rise = (-r_star_rise)
        c1_rise = pi1_held*r_star_rise
        c2_rise = eta_held*(c0_rise + c1_rise + v_star_rise)
        c3_rise = inv1_rise*pi1_held
        c4_rise = u_plain - c1_rise - v_star_rise
        c5_rise = K_rise*(inv_U*inv_U)
        c6_rise = c5_rise*inv0_rise
        c7_rise = c6_rise*inv1_rise
        c8_rise = 0.16666666666666666*h
        c9_rise = eta_held - 1.0
        f_v_star_rise_rise = c0_rise + c5_rise*(c4_rise + c2_rise*c3_rise)  # rate [-]
        f_r_star_rise_rise = c7_rise*((-c2_rise) - c4_rise)  # rate [-]
        J_00_rise = c5_rise*c8_rise*(c3_rise*eta_held - 1.0)
        J_01_rise = c8_rise*(c5_rise*c9_rise*pi1_held - 1.0)
        J_10_rise = (-c7_rise*c8_rise*c9_rise)
        J_11_rise = c6_rise*c8_rise*(inv1_rise*pi1_held - eta_held)
        f_v_star_rise_u_plain_rise = c5_rise
        f_r_star_rise_u_plain_rise = (-c7_rise)
        p0_rise = J_00_rise*J_11_rise - J_01_rise*J_10_rise
        p1_rise = (-J_00_rise) - J_11_rise
        n0_rise = 1.0 - 1.5*p0_rise
        n1_rise = (-2.0) - 1.5*p1_rise
        i_det_rise = (1.0/((n0_rise*n0_rise) + p0_rise*(n1_rise*n1_rise) - n0_rise*n1_rise*p1_rise))  # det N > 0 for every real J
        i0_rise = i_det_rise*(n0_rise - n1_rise*p1_rise)
        i1_rise = (-i_det_rise*n1_rise)
        E0_rise = i0_rise - i1_rise*p0_rise  # half a step
        E1_rise = i0_rise + i1_rise - i1_rise*p1_rise
        H0_rise = 0.5*h*i0_rise + 0.25*h*i1_rise*p0_rise  # change per rate over half a step
        H1_rise = 0.5*h*i1_rise + 0.25*h*i1_rise*p1_rise - 0.25*h*i0_rise
        g0_rise = H0_rise*(1.0 + E0_rise) - E1_rise*H1_rise*p0_rise
        g1_rise = E1_rise*H0_rise + H1_rise*(1.0 + E0_rise) - E1_rise*H1_rise*p1_rise
        wi0_rise = (-p0_rise*(0.4375 + 0.1875*p1_rise))
        wi1_rise = 0.1875*p0_rise - 0.5 - p1_rise*(0.4375 + 0.1875*p1_rise)
        wh0_rise = i0_rise*wi0_rise - i1_rise*p0_rise*wi1_rise
        wh1_rise = i0_rise*wi1_rise + i1_rise*wi0_rise - i1_rise*p1_rise*wi1_rise
        w0_rise = i0_rise*wh0_rise - i1_rise*p0_rise*wh1_rise  # W/h in powers of J
        w1_rise = i0_rise*wh1_rise + i1_rise*wh0_rise - i1_rise*p1_rise*wh1_rise
        G_00_rise = g0_rise + J_00_rise*g1_rise  # change per rate
        G_01_rise = J_01_rise*g1_rise
        G_10_rise = J_10_rise*g1_rise
        G_11_rise = g0_rise + J_11_rise*g1_rise
        ramp_rise = h*steer_change
        ramp_0_rise = ramp_rise*w0_rise
        ramp_1_rise = ramp_rise*w1_rise
        slope1_v_star_rise_rise = J_00_rise*f_v_star_rise_u_plain_rise + J_01_rise*f_r_star_rise_u_plain_rise
        slope1_r_star_rise_rise = J_10_rise*f_v_star_rise_u_plain_rise + J_11_rise*f_r_star_rise_u_plain_rise
        rise_v_star_rise_rise = f_v_star_rise_u_plain_rise*ramp_0_rise + ramp_1_rise*slope1_v_star_rise_rise  # the input rises or falls in a straight line [-]
        rise_r_star_rise_rise = f_r_star_rise_u_plain_rise*ramp_0_rise + ramp_1_rise*slope1_r_star_rise_rise
        d_v_star_rise_rise = rise_v_star_rise_rise + G_00_rise*f_v_star_rise_rise + G_01_rise*f_r_star_rise_rise  # change over the step [-]
        d_r_star_rise_rise = rise_r_star_rise_rise + G_10_rise*f_v_star_rise_rise + G_11_rise*f_r_star_rise_rise  # change over the step [-]
        v_star_rise = d_v_star_rise_rise + v_star_rise
        r_star_rise = d_r_star_rise_rise + r_star_rise
        lean = (1.0 if (1.0) < (companion_rate*dt) else companion_rate*dt)
        v_star_plain = v_star_plain + lean*(v_star_held - v_star_plain)
        r_star_plain = r_star_plain + lean*(r_star_held - r_star_plain)
        v_star_fall = v_star_fall + lean*(v_star_held - v_star_fall)
        r_star_fall = r_star_fall + lean*(r_star_held - r_star_fall)
        v_star_rise = v_star_rise + lean*(v_star_held - v_star_rise)
        r_star_rise = r_star_rise + lean*(r_star_held - r_star_rise)
        validity_now = inv_L*r_star_held*(at_U*at_U)  # lateral acceleration
        validity_then = validity*(1.0 - (1.0 if (1.0) < (dt*validity_rate) else dt*validity_rate))
        validity = ((validity_now*validity_now) if ((validity_now*validity_now)) > (validity_then) else validity_then)
        if usable > 0.5:  # measurement
            c_0 = P_1*output_scale
            c_1 = P_3*output_scale
            c_2 = P_4*output_scale
            innovation = measured - output_bias_held - output_scale*r_star_held
            spread = noise_now + c_1*output_scale
            inv_spread = (1.0/spread)
            signature_fall = output_scale*r_star_fall - output_scale*r_star_miss_fall - output_scale*r_star_plain  # what would be missed after a fall
            signature_rise = output_scale*r_star_rise - output_scale*r_star_miss_rise - output_scale*r_star_plain  # what would be missed after a rise
            rest_same = innovation
            rest_fall = innovation - signature_fall
            rest_rise = innovation - signature_rise
            rest_least = inv_spread*(((rest_fall*rest_fall) if ((rest_fall*rest_fall)) < ((rest_rise*rest_rise)) else (rest_rise*rest_rise)) if (((rest_fall*rest_fall) if ((rest_fall*rest_fall)) < ((rest_rise*rest_rise)) else (rest_rise*rest_rise))) < ((rest_same*rest_same)) else (rest_same*rest_same))
            weight = (outlier_ratio/rest_least if outlier_ratio < rest_least else 1.0)  # what no hypothesis explains counts for less
            gain_0 = c_0*inv_spread*weight
            gain_1 = c_1*inv_spread*weight
            gain_2 = c_2*inv_spread*weight
            P_0 = P_0 - c_0*gain_0
            P_1 = P_1 - c_1*gain_0
            P_2 = P_2 - c_2*gain_0
            P_3 = P_3 - c_1*gain_1
            P_4 = P_4 - c_2*gain_1
            P_5 = P_5 - c_2*gain_2
            v_star_held = v_star_held + gain_0*innovation
            r_star_held = r_star_held + gain_1*innovation
            disturbance_held = disturbance_held + gain_2*innovation
            v_star_miss_fall = v_star_miss_fall + gain_0*signature_fall
            r_star_miss_fall = r_star_miss_fall + gain_1*signature_fall
            disturbance_miss_fall = disturbance_miss_fall + gain_2*signature_fall
            v_star_miss_rise = v_star_miss_rise + gain_0*signature_rise
            r_star_miss_rise = r_star_miss_rise + gain_1*signature_rise
            disturbance_miss_rise = disturbance_miss_rise + gain_2*signature_rise
            smooth_share = (1.0 if (1.0) < (dt*smooth_rate) else dt*smooth_rate)
            inv_white = inv_spread*(2.0 - smooth_share)/smooth_share  # 1/variance of the average of white noise
            smooth_same = smooth_same + smooth_share*(rest_same - smooth_same)
            rough_same = rough_same + (inv_white*(smooth_same*smooth_same) - rough_same)*(1.0 if (1.0) < (dt*rough_rate) else dt*rough_rate)
            smooth_fall = smooth_fall + smooth_share*(rest_fall - smooth_fall)
            rough_fall = rough_fall + (inv_white*(smooth_fall*smooth_fall) - rough_fall)*(1.0 if (1.0) < (dt*rough_rate) else dt*rough_rate)
            smooth_rise = smooth_rise + smooth_share*(rest_rise - smooth_rise)
            rough_rise = rough_rise + (inv_white*(smooth_rise*smooth_rise) - rough_rise)*(1.0 if (1.0) < (dt*rough_rate) else dt*rough_rate)
            rough = (1.0 if (1.0) > (((rough_fall if (rough_fall) < (rough_rise) else rough_rise) if ((rough_fall if (rough_fall) < (rough_rise) else rough_rise)) < (rough_same) else rough_same)) else ((rough_fall if (rough_fall) < (rough_rise) else rough_rise) if ((rough_fall if (rough_fall) < (rough_rise) else rough_rise)) < (rough_same) else rough_same))
            slope = 0.5*signature_fall/size_fall + 0.5*signature_rise/size_rise
            fresh = inv_spread*(slope*slope)  # information
            known = fresh + known
            hearing = hearing + (fresh/dt - hearing)*(1.0 if (1.0) < (dt*hearing_rate) else dt*hearing_rate)
            heard = (0.0 if (0.0) > ((heard + ((-dt) if own_variance > variance_most else (dt if (code < 0.5) and (hearing > hearing_least) else 0.0)) if (heard + ((-dt) if own_variance > variance_most else (dt if (code < 0.5) and (hearing > hearing_least) else 0.0))) < (heard_least + heard_spare) else heard_least + heard_spare)) else (heard + ((-dt) if own_variance > variance_most else (dt if (code < 0.5) and (hearing > hearing_least) else 0.0)) if (heard + ((-dt) if own_variance > variance_most else (dt if (code < 0.5) and (hearing > hearing_least) else 0.0))) < (heard_least + heard_spare) else heard_least + heard_spare))
            score_keep = 1.0 - (1.0 if (1.0) < (dt*score_rate) else dt*score_rate)
            score = score*score_keep + innovation*inv_spread*slope
            score_variance = fresh + score_variance*(score_keep*score_keep)
            distrust = distrust + ((16.0 if (16.0) < ((score*score)/(1e-09 + score_variance)) else (score*score)/(1e-09 + score_variance)) - distrust)*(1.0 if (1.0) < (distrust_rate*dt) else distrust_rate*dt)
            doubt = rough*(1.0 if (1.0) > (1.0 + distrust_share*(distrust - 1.0)) else 1.0 + distrust_share*(distrust - 1.0))
            trust = weight/doubt
            gain_bound = dt*gain_most/(1.0 if (1.0) > (rough/rough_free) else rough/rough_free)
            if (heard > heard_least) and (hearing > hearing_least) and (known > known_least) and (validity < (validity_limit*validity_limit)):  # in the linear range, with enough to hear
                lately_fall = lately_fall + (inv_spread*signature_fall*trust*(innovation - 0.5*signature_fall) - lately_fall)*(1.0 if (1.0) < (dt*gain_rate) else dt*gain_rate)
                lean_fall = smooth_same - smooth_fall  # the signature's slow part
                if lean_fall*side_fall <= 0.0:  # the next half-wave
                    side_fall = lean_fall
                    piece_fall = 0.0
                gained_fall = ((-gain_bound) if ((-gain_bound)) > ((gain_bound if (gain_bound) < (lately_fall) else lately_fall)) else (gain_bound if (gain_bound) < (lately_fall) else lately_fall))
                beyond_fall = (lately_fall*piece_share if rough_fall < piece_fit*rough_same else 0.0)  # what a half-wave that is used up still counts for
                allowed_fall = (gained_fall if (gained_fall) < ((beyond_fall if (beyond_fall) > (piece_most - piece_fall) else piece_most - piece_fall)) else (beyond_fall if (beyond_fall) > (piece_most - piece_fall) else piece_most - piece_fall))
                piece_fall = allowed_fall + piece_fall
                evidence_fall = allowed_fall + evidence_fall*(1.0 - (1.0 if (1.0) < (dt*evidence_leak) else dt*evidence_leak))
                age_fall = age_fall + dt
                slope_fall = signature_fall/size_fall  # of the innovation to ln K
                weight_sum_fall = weight_sum_fall + inv_spread*weight*(slope_fall*slope_fall)
                score_sum_fall = score_sum_fall + innovation*inv_spread*slope_fall*weight
                if (age_fall > age_most) or (evidence_fall <= (-evidence_floor)):  # nothing speaks for it
                    evidence_fall = 0.0
                    age_fall = 0.0
                    weight_sum_fall = 0.0
                    score_sum_fall = 0.0
                    lately_fall = 0.0
                    side_fall = 0.0
                    piece_fall = 0.0
                    v_star_fall = v_star_plain
                    r_star_fall = r_star_plain
                    smooth_fall = smooth_same
                    rough_fall = rough_same
                    v_star_miss_fall = 0.0
                    r_star_miss_fall = 0.0
                    disturbance_miss_fall = 0.0
                lately_rise = lately_rise + (inv_spread*signature_rise*trust*(innovation - 0.5*signature_rise) - lately_rise)*(1.0 if (1.0) < (dt*gain_rate) else dt*gain_rate)
                lean_rise = smooth_same - smooth_rise  # the signature's slow part
                if lean_rise*side_rise <= 0.0:  # the next half-wave
                    side_rise = lean_rise
                    piece_rise = 0.0
                gained_rise = ((-gain_bound) if ((-gain_bound)) > ((gain_bound if (gain_bound) < (lately_rise) else lately_rise)) else (gain_bound if (gain_bound) < (lately_rise) else lately_rise))
                beyond_rise = (lately_rise*piece_share if rough_rise < piece_fit*rough_same else 0.0)  # what a half-wave that is used up still counts for
                allowed_rise = (gained_rise if (gained_rise) < ((beyond_rise if (beyond_rise) > (piece_most - piece_rise) else piece_most - piece_rise)) else (beyond_rise if (beyond_rise) > (piece_most - piece_rise) else piece_most - piece_rise))
                piece_rise = allowed_rise + piece_rise
                evidence_rise = allowed_rise + evidence_rise*(1.0 - (1.0 if (1.0) < (dt*evidence_leak) else dt*evidence_leak))
                age_rise = age_rise + dt
                slope_rise = signature_rise/size_rise  # of the innovation to ln K
                weight_sum_rise = weight_sum_rise + inv_spread*weight*(slope_rise*slope_rise)
                score_sum_rise = score_sum_rise + innovation*inv_spread*slope_rise*weight
                if (age_rise > age_most) or (evidence_rise <= (-evidence_floor)):  # nothing speaks for it
                    evidence_rise = 0.0
                    age_rise = 0.0
                    weight_sum_rise = 0.0
                    score_sum_rise = 0.0
                    lately_rise = 0.0
                    side_rise = 0.0
                    piece_rise = 0.0
                    v_star_rise = v_star_plain
                    r_star_rise = r_star_plain
                    smooth_rise = smooth_same
                    rough_rise = rough_same
                    v_star_miss_rise = 0.0
                    r_star_miss_rise = 0.0
                    disturbance_miss_rise = 0.0
                if ((evidence_fall - small_price*(0.0 if (0.0) > (size_fall + size_large) else size_fall + size_large)) > threshold_fall) and ((size_fall*size_fall) > sizes_squared*variance_held) and (rough_fall < (rough_free + rough_same*rough_share)):  # a fall
                    alarm = 1.0
                    onset_age = age_fall
                    change = size_fall
                    change_variance = doubt/(size_weight + weight_sum_fall)
                if ((evidence_rise - small_price*(0.0 if (0.0) > (size_large - size_rise) else size_large - size_rise)) > threshold_rise) and ((size_rise*size_rise) > sizes_squared*variance_held) and (rough_rise < (rough_free + rough_same*rough_share)):  # a rise
                    alarm = 2.0
                    onset_age = age_rise
                    change = size_rise
                    change_variance = doubt/(size_weight + weight_sum_rise)
                if alarm > 0.5:  # the reference is learnt anew
                    evidence_fall = 0.0
                    age_fall = 0.0
                    weight_sum_fall = 0.0
                    score_sum_fall = 0.0
                    lately_fall = 0.0
                    side_fall = 0.0
                    piece_fall = 0.0
                    v_star_fall = v_star_plain
                    r_star_fall = r_star_plain
                    smooth_fall = smooth_same
                    rough_fall = rough_same
                    v_star_miss_fall = 0.0
                    r_star_miss_fall = 0.0
                    disturbance_miss_fall = 0.0
                    evidence_rise = 0.0
                    age_rise = 0.0
                    weight_sum_rise = 0.0
                    score_sum_rise = 0.0
                    lately_rise = 0.0
                    side_rise = 0.0
                    piece_rise = 0.0
                    v_star_rise = v_star_plain
                    r_star_rise = r_star_plain
                    smooth_rise = smooth_same
                    rough_rise = rough_same
                    v_star_miss_rise = 0.0
                    r_star_miss_rise = 0.0
                    disturbance_miss_rise = 0.0
                    heard = heard_least - heard_again
        last_input = u_now
        last_U = U_used
    else:
        status = 7.0
    reference = K_held
    evidence_of_fall = evidence_fall - small_price*(0.0 if (0.0) > (size_fall + size_large) else size_fall + size_large)
    evidence_of_rise = evidence_rise - small_price*(0.0 if (0.0) > (size_large - size_rise) else size_large - size_rise)
    armed = (1.0 if (heard > heard_least) and (hearing > hearing_least) and (known > known_least) else 0.0)
    information_rate = hearing
    state[:] = [v_star_held, r_star_held, disturbance_held, P_0, P_1, P_2, P_3, P_4, P_5, v_star_plain, r_star_plain, v_star_fall, r_star_fall, v_star_miss_fall, r_star_miss_fall, disturbance_miss_fall, v_star_rise, r_star_rise, v_star_miss_rise, r_star_miss_rise, disturbance_miss_rise, K_held, pi1_held, eta_held, rho_held, input_offset_held, output_bias_held, variance_held, size_fall, evidence_fall, age_fall, weight_sum_fall, score_sum_fall, lately_fall, side_fall, piece_fall, size_rise, evidence_rise, age_rise, weight_sum_rise, score_sum_rise, lately_rise, side_rise, piece_rise, smooth_same, smooth_fall, smooth_rise, rough_same, rough_fall, rough_rise, score, score_variance, distrust, known, hearing, heard, validity, last_input, last_U, started]
    return int(status), [alarm, onset_age, change, change_variance, reference, evidence_of_fall, evidence_of_rise, armed, information_rate]
