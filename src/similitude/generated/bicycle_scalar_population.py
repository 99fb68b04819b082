"""Kalman filter of one unknown for the bicycle: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle, Brennan & Alleyne 2004, eqs 1-4
base: m, L, U
unknown: K; frozen: pi1, eta, rho

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_scalar_population'
OPERATIONS = 207
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ()
REPORTS = False  # outputs are worked out when they are asked for, by a function of their own

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('pi1', '-', 'frozen a/L, position of the centre of gravity', 1),
    ('eta', '-', 'frozen rear over front cornering coefficient; > 1 understeers', 1),
    ('rho', '-', 'frozen Iz/(m a b), yaw inertia ratio', 1),
    ('sample_time', 's', 'time between samples', 1),
    ('K_start', 'm^2/s^2', 'K before the first update', 1),
    ('K_low', 'm^2/s^2', 'least K of the population', 1),
    ('K_high', 'm^2/s^2', 'greatest K of the population', 1),
    ('start_variance', '-', 'variance of ln K of the population', 1),
    ('frozen_variance', '-', "what the frozen unknowns' spread adds to it", 1),
    ('noise_variance', '(rad/s)^2', 'white noise of r a sample, > 0', 1),
    ('drift', '1/s', 'diffusion of ln K', 1),
    ('structure_time', 's', 'how long an error of the model lasts', 1),
    ('scatter_rate', '1/s', "averaging rate of the error's mean square", 1),
    ('offset_rate', '1/s', 'rate at which offsets are followed and taken out', 1),
    ('observer_rate', '1/s', 'pull of the model towards the measurement', 1),
    ('move_limit', '-', 'greatest move of ln K in one sample', 1),
    ('excitation_least', '-', 'least mean square of the sensitivity to learn from, in its units', 1),
    ('excitation_rate', '1/s', 'averaging rate of that mean square', 1),
    ('variance_limit', '-', 'greatest variance that is reported', 1),
    ('settle_samples', '-', 'whole samples in a row before an update, 3 or more', 1),
    ('dt_low', 's', 'shortest step that counts as one sample', 1),
    ('dt_high', 's', 'longest step that counts as one sample', 1),
    ('U_least', 'm/s', 'least forward speed to learn at, > 0', 1),
    ('input_limit', 'rad', 'greatest believable delta', 1),
    ('output_limit', 'rad/s', 'greatest believable r', 1),
    ('output_jump', 'rad/s', 'greatest believable change of r in one sample', 1),
    ('signal_limit', 'm/s', 'greatest believable scale', 1),
    ('validity_limit', 'm/s^2', "edge of the model's linear range", 1),
)

STATE = (
    ('K', 'm^2/s^2', 'Caf L/m, front cornering stiffness per mass and length', 1),
    ('p', '-', 'variance of ln K', 1),
    ('input_gain', '-', 'input gain of the model', 1),
    ('damping', '-', 'damping of the model', 1),
    ('stiffness', '-', 'stiffness of the model', 1),
    ('pair_output', '-', 'pair output of the model', 1),
    ('pair_input', '-', 'pair input of the model', 1),
    ('inv_interval', '1/s', '1/sample time', 1),
    ('y', 'rad/s', 'r of the model', 1),
    ('w', 'rad/s/s', 'what the other state adds to its rate', 1),
    ('y_slope', 'rad/s', 'sensitivity of y to ln K', 1),
    ('w_slope', 'rad/s/s', 'the same of w', 1),
    ('error_offset', 'rad/s', 'slow part of the error', 1),
    ('slope_offset', 'rad/s', 'slow part of the sensitivity', 1),
    ('mean_square', '(rad/s)^2', 'mean square of the error', 1),
    ('excitation', '(rad/s)^2', 'mean square of the sensitivity', 1),
    ('slowness', '1/(m/s)', '1/last U', 1),
    ('last_input', 'rad', 'last usable input', 1),
    ('last_measured', 'rad/s', 'last usable measurement', 1),
    ('last_U', 'm/s', 'last forward speed fast enough to learn', 1),
    ('fresh', '-', 'usable samples in a row', 1),
    ('started', '-', '0 before the first usable scale, 1 after', 1),
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
)


def init(config):
    """The flat state before the first sample, from the flat configuration."""
    pi1 = config[1]
    eta = config[2]
    rho = config[3]
    sample_time = config[4]
    K_start = config[5]
    start_variance = config[8]
    U_least = config[23]
    K = K_start
    p = start_variance
    input_gain = (-1.0/(rho*(pi1 - 1.0)))
    damping = (-(eta + pi1 + rho + eta*pi1*rho - eta*pi1 - pi1*rho)/(rho*(pi1 - 1.0)))
    stiffness = (-(eta - 1.0)/(rho*(pi1 - 1.0)))
    pair_output = eta/(rho*((pi1 - 1.0)*(pi1 - 1.0)))
    pair_input = eta/(rho*((pi1 - 1.0)*(pi1 - 1.0)))
    inv_interval = (1.0/sample_time)
    y = 0.0
    w = 0.0
    y_slope = 0.0
    w_slope = 0.0
    error_offset = 0.0
    slope_offset = 0.0
    mean_square = 0.0
    excitation = 0.0
    slowness = (1.0/U_least)
    last_input = 0.0
    last_measured = 0.0
    last_U = U_least
    fresh = 0.0
    started = 0.0
    return [K, p, input_gain, damping, stiffness, pair_output, pair_input, inv_interval, y, w, y_slope, w_slope, error_offset, slope_offset, mean_square, excitation, slowness, last_input, last_measured, last_U, fresh, started]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    L = config[0]
    K_low = config[6]
    K_high = config[7]
    start_variance = config[8]
    frozen_variance = config[9]
    noise_variance = config[10]
    drift = config[11]
    structure_time = config[12]
    scatter_rate = config[13]
    offset_rate = config[14]
    observer_rate = config[15]
    move_limit = config[16]
    excitation_least = config[17]
    excitation_rate = config[18]
    variance_limit = config[19]
    settle_samples = config[20]
    dt_low = config[21]
    dt_high = config[22]
    U_least = config[23]
    input_limit = config[24]
    output_limit = config[25]
    output_jump = config[26]
    signal_limit = config[27]
    validity_limit = config[28]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    K = state[0]
    p = state[1]
    input_gain = state[2]
    damping = state[3]
    stiffness = state[4]
    pair_output = state[5]
    pair_input = state[6]
    inv_interval = state[7]
    y = state[8]
    w = state[9]
    y_slope = state[10]
    w_slope = state[11]
    error_offset = state[12]
    slope_offset = state[13]
    mean_square = state[14]
    excitation = state[15]
    slowness = state[16]
    last_input = state[17]
    last_measured = state[18]
    last_U = state[19]
    fresh = state[20]
    started = state[21]
    edge = 0.0
    estimate = 0.0
    excited = 0.0
    innovation = 0.0
    innovation_variance = 0.0
    live = 0.0
    predicted = 0.0
    scale_now = 0.0
    status = 0.0
    u_now = 0.0
    usable = 0.0
    variance = 0.0
    y_now = 0.0
    predicted = last_measured
    innovation = 0.0
    if (dt < 1000000.0) and (dt > 0.0):  # time must advance
        status = 1.0
        usable = 1.0
        if (U < signal_limit) and (U > (-signal_limit)) and (input < input_limit) and (input > (-input_limit)):  # a missing input or scale is held
            u_now = input
            scale_now = U
        else:
            u_now = last_input
            scale_now = last_U
            usable = 0.0
        if (measured < output_limit) and (measured > (-output_limit)) and (not ((((measured - last_measured) < (-output_jump)) or ((measured - last_measured) > output_jump)) and (fresh > 0.5))):  # so is an output
            y_now = measured
        else:
            y_now = last_measured
            usable = 0.0
        if scale_now > U_least:  # fast enough to see the dynamics
            if (scale_now < last_U) or (scale_now > last_U):  # another scale
                last_U = scale_now
                slowness = (1.0/last_U)
            live = 1.0
            started = 1.0
        else:
            live = 0.0
            status = 6.0
        if (fresh > 0.5) and (not ((dt < dt_high) and (dt > dt_low))):  # the sample before is elsewhere
            fresh = 0.0
            status = 5.0
        if usable > 0.5:  # usable samples in a row
            fresh = 1.0 + (fresh if (fresh) < (settle_samples) else settle_samples)
        else:
            fresh = 0.0
            status = 4.0
        u = 0.5*last_input + 0.5*u_now  # mean of the sample's two ends
        a = K*damping*slowness/L
        b_1 = K*stiffness/((L*L))
        b_2 = pair_output*(K*K)*(slowness*slowness)/((L*L))
        b = b_1 + b_2
        b_slope = b_1 + 2.0*b_2
        c = K*input_gain/((L*L))
        d = pair_input*slowness*(K*K)/((L*L*L))
        if (dt < dt_high) and (dt > dt_low) and (live > 0.5):  # the step is one sample long
            q = 0.5*dt
            qa = a*q
            inv_det = (1.0/(1.0 + qa + b*(q*q)))
            y_forced = w + 2.0*d*q*u - b*q*y
            y_after = inv_det*(q*(w + y_forced + 2.0*c*u) + y*(1.0 - qa))
            y_middle = 0.5*y + 0.5*y_after
            w = y_forced - b*q*y_after
            y_slope_forced = w_slope + 2.0*q*(2.0*d*u - b_slope*y_middle) - b*q*y_slope
            y_slope_after = inv_det*(q*(w_slope + y_slope_forced + 2.0*c*u - 2.0*a*y_middle) + y_slope*(1.0 - qa))
            w_slope = y_slope_forced - b*q*y_slope_after
            y = y_after
            y_slope = y_slope_after
            error = y_now - y
            follow = usable*(1.0 if (1.0) < (dt*offset_rate) else dt*offset_rate)
            error_offset = error_offset + follow*(error - error_offset)
            slope_offset = slope_offset + follow*(y_slope - slope_offset)
            psi = y_slope - slope_offset  # sensitivity without its slow part
            residual = error - error_offset  # error without its slow part
            predicted = y_now - residual
            if usable > 0.5:
                innovation = residual
                mean_square = mean_square + ((residual*residual) - mean_square)*(1.0 if (1.0) < (dt*scatter_rate) else dt*scatter_rate)
                drive = psi  # what the input alone does to the regression
                excitation = excitation + ((drive*drive) - excitation)*(1.0 if (1.0) < (dt*excitation_rate) else dt*excitation_rate)
                excited = (1.0 if excitation > excitation_least else 0.0)
                if (excited > 0.5) and (fresh > settle_samples):  # the input says something of the unknown
                    weighed = noise_variance + 2.0*inv_interval*structure_time*(0.0 if (0.0) > (mean_square - noise_variance) else mean_square - noise_variance)
                    gain = p*psi/((weighed + p*(psi*psi)))
                    wanted = gain*residual
                    move = ((-move_limit) if ((-move_limit)) > ((move_limit if (move_limit) < (wanted) else wanted)) else (move_limit if (move_limit) < (wanted) else wanted))
                    p = p - gain*p*psi
                    K = K*(1.0 + move*(1.0 + move*(0.5 + 0.16666666666666666*move)))
                    edge = 0.0
                    if (K < K_low) or (K > K_high):  # no car is softer or stiffer
                        K = (K if (K) > (K_low) else K_low)
                        K = (K if (K) < (K_high) else K_high)
                        edge = 1.0
                    status = 0.0
                    if (last_U*last_U)*(y_now*y_now) > (validity_limit*validity_limit):
                        status = 2.0
                    if edge > 0.5:  # the population's edge
                        status = 3.0
            p = (start_variance if (start_variance) < (p + drift*dt) else p + drift*dt)  # unseen, K may change
            pull = usable*(1.0 if (1.0) < (dt*observer_rate) else dt*observer_rate)
            y = y + pull*residual
            y_slope = y_slope - psi*pull
        else:
            y = y_now
            w = a*y_now - c*u
            y_slope = 0.0
            w_slope = 0.0
            error_offset = 0.0
            slope_offset = 0.0
        last_input = u_now
        last_measured = y_now
    else:
        status = 7.0
    estimate = K
    innovation_variance = (mean_square if (mean_square) > (noise_variance) else noise_variance)
    variance = (variance_limit if (variance_limit) < (frozen_variance + p) else frozen_variance + p)
    state[:] = [K, p, input_gain, damping, stiffness, pair_output, pair_input, inv_interval, y, w, y_slope, w_slope, error_offset, slope_offset, mean_square, excitation, slowness, last_input, last_measured, last_U, fresh, started]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance]
