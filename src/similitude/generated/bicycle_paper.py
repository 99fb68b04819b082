"""Regression of the paper for the bicycle: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle, Brennan & Alleyne 2004, eqs 1-4
base: m, L, U
unknown: pi3; in proportion to it: pi4
m1/T = pi1/pi5
m2/T = (pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1))/pi5

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_paper'
OPERATIONS = 93
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ()

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('pi1', '-', 'frozen pi1', 1),
    ('pi4_slope', '-', 'frozen pi4/pi3', 1),
    ('pi5', '-', 'frozen pi5', 1),
    ('sample_time', 's', 'sample time the filters are designed for', 1),
    ('poles_1', '-', 'first section of the high-pass: 1 + a1 + a2, a2', 2),
    ('poles_2', '-', 'second section of the high-pass: 1 + a1 + a2, a2', 2),
    ('pi3_start', '-', 'pi3 before the first update', 1),
    ('normal_start', '-', 'sum of squared regressors before the first update, dimensionless', 1),
    ('normal_least', '(rad/s)^2/(m^2/s^2)^2', 'added at each update, > 0', 1),
    ('forgetting', '-', 'share of the past kept at each update', 1),
    ('dead_zone', 'rad/s', '|r| that must be exceeded for an update', 1),
    ('settle_samples', '-', 'whole samples in a row before an update, 3 or more', 1),
    ('noise_variance', '(rad/s)^2', 'least variance of r a sample, > 0', 1),
    ('K_low', 'm^2/s^2', 'least K that is reported, > 0', 1),
    ('K_limit', 'm^2/s^2', 'greatest magnitude of K', 1),
    ('variance_limit', '-', 'greatest variance that is reported', 1),
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
    ('from_input', '-', 'regressor per change of input, but for what the scale changes', 1),
    ('from_output', '-', 'the same per change of output', 1),
    ('theta', 'm^2/s^2', 'K of the regression', 1),
    ('normal', '(rad/s)^2/(m^2/s^2)^2', 'sum of squared regressors, forgetting', 1),
    ('mean_square', '(rad/s)^2', 'mean square of the residual', 1),
    ('weight', '-', 'updates the mean square rests on', 1),
    ('information', '-', 'information gained about ln K', 1),
    ('log_variance', '-', 'variance of ln K at the last update', 1),
    ('last_input', 'rad', 'last usable input', 1),
    ('input_change', 'rad', 'its last change', 1),
    ('input_1', 'rad', 'what the first section holds of it', 1),
    ('input_1_change', 'rad', 'its last change', 1),
    ('input_2', 'rad', 'what the second section holds of it', 1),
    ('input_2_change', 'rad', 'its last change', 1),
    ('last_measured', 'rad/s', 'last usable output', 1),
    ('output_change', 'rad/s', 'its last change', 1),
    ('output_1', 'rad/s', 'what the first section holds of it', 1),
    ('output_1_change', 'rad/s', 'its last change', 1),
    ('output_2', 'rad/s', 'what the second section holds of it', 1),
    ('output_2_change', 'rad/s', 'its last change', 1),
    ('last_U', 'm/s', 'last forward speed fast enough to learn', 1),
    ('wait', '-', 'usable samples until the filters have settled', 1),
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
    ('pi3', '-', 'group at the last usable scale', 1),
)


def init(config):
    """The flat state before the first sample, from the flat configuration."""
    L = config[0]
    pi1 = config[1]
    pi4_slope = config[2]
    pi5 = config[3]
    sample_time = config[4]
    pi3_start = config[9]
    normal_start = config[10]
    settle_samples = config[14]
    variance_limit = config[18]
    U_least = config[21]
    last_U = U_least
    from_input = pi1*sample_time/((L*L)*pi5)
    from_output = sample_time*((pi1*pi1) + pi4_slope*((pi1 - 1.0)*(pi1 - 1.0)) + pi5*(1.0 + pi4_slope))/(L*pi5)
    theta = pi3_start*(last_U*last_U)
    normal = normal_start/((L*L)*(last_U*last_U))
    mean_square = 0.0
    weight = 0.0
    information = 0.0
    log_variance = variance_limit
    last_input = 0.0
    input_change = 0.0
    input_1 = 0.0
    input_1_change = 0.0
    input_2 = 0.0
    input_2_change = 0.0
    last_measured = 0.0
    output_change = 0.0
    output_1 = 0.0
    output_1_change = 0.0
    output_2 = 0.0
    output_2_change = 0.0
    wait = 1.0 + settle_samples
    return [from_input, from_output, theta, normal, mean_square, weight, information, log_variance, last_input, input_change, input_1, input_1_change, input_2, input_2_change, last_measured, output_change, output_1, output_1_change, output_2, output_2_change, last_U, wait]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    L = config[0]
    poles_1_0 = config[5]
    poles_1_1 = config[6]
    poles_2_0 = config[7]
    poles_2_1 = config[8]
    pi3_start = config[9]
    normal_start = config[10]
    normal_least = config[11]
    forgetting = config[12]
    dead_zone = config[13]
    settle_samples = config[14]
    noise_variance = config[15]
    K_low = config[16]
    K_limit = config[17]
    variance_limit = config[18]
    dt_low = config[19]
    dt_high = config[20]
    U_least = config[21]
    input_limit = config[22]
    output_limit = config[23]
    output_jump = config[24]
    signal_limit = config[25]
    validity_limit = config[26]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    from_input = state[0]
    from_output = state[1]
    theta = state[2]
    normal = state[3]
    mean_square = state[4]
    weight = state[5]
    information = state[6]
    log_variance = state[7]
    last_input = state[8]
    input_change = state[9]
    input_1 = state[10]
    input_1_change = state[11]
    input_2 = state[12]
    input_2_change = state[13]
    last_measured = state[14]
    output_change = state[15]
    output_1 = state[16]
    output_1_change = state[17]
    output_2 = state[18]
    output_2_change = state[19]
    last_U = state[20]
    wait = state[21]
    estimate = 0.0
    expected = 0.0
    information_gained = 0.0
    innovation = 0.0
    innovation_variance = 0.0
    input_step = 0.0
    inverse = 0.0
    learnt = 0.0
    output_step = 0.0
    pi3 = 0.0
    predicted = 0.0
    scale_now = 0.0
    status = 0.0
    variance = 0.0
    waiting = 0.0
    y_now = 0.0
    waiting = wait
    status = 1.0
    if not ((dt < dt_high) and (dt > dt_low)):  # the sample before is elsewhere
        if (dt < 1000000.0) and (dt > 0.0):  # time must advance
            if waiting <= settle_samples:
                status = 5.0
            waiting = 1.0 + settle_samples
        else:
            status = 7.0
    if status < 6.5:
        if (abs(U) < signal_limit) and (abs(input) < input_limit):  # a missing input or scale is held
            input_step = input - last_input
            last_input = input
            scale_now = U
        else:
            input_step = 0.0
            scale_now = last_U
            status = 4.0
        if ((abs(last_measured - measured) < output_jump) or (waiting > settle_samples)) and (abs(measured) < output_limit):  # so is an output
            output_step = measured - last_measured
            y_now = measured
        else:
            output_step = 0.0
            y_now = last_measured
            status = 4.0
        if (status < 4.5) and (status > 3.5):
            waiting = 1.0 + settle_samples
        else:
            if waiting > 0.5:  # usable samples in a row
                waiting = waiting - 1.0
        if scale_now <= U_least:  # too slow to see the dynamics
            scale_now = last_U
            waiting = (1.0 if (1.0) > (waiting) else waiting)
            if status < 1.5:
                status = 6.0
        last_U = scale_now
        last_measured = y_now
        wait = waiting
        inverse = (1.0/scale_now)
        input_bend = input_step - input_change  # second difference
        input_change = input_step
        input_1_now = input_bend + input_1_change*poles_1_1 - input_1*poles_1_0
        input_bend_1 = input_1_now - input_1_change
        input_1 = input_1 + input_1_now
        input_1_change = input_1_now
        input_2_now = input_bend_1 + input_2_change*poles_2_1 - input_2*poles_2_0
        output_bend = output_step - output_change  # second difference
        output_change = output_step
        output_1_now = output_bend + output_1_change*poles_1_1 - output_1*poles_1_0
        output_bend_1 = output_1_now - output_1_change
        output_1 = output_1 + output_1_now
        output_1_change = output_1_now
        output_2_now = output_bend_1 + output_2_change*poles_2_1 - output_2*poles_2_0
        phi = from_input*input_2_change - from_output*inverse*output_2_change  # regressor, eqs 25-26
        expected = phi*theta
        y = output_2_now - output_2_change  # second difference, eq 24
        residual = y - expected
        predicted = y_now - residual  # the newest output has weight one in y
        if (abs(y_now) > dead_zone) and (waiting < 0.5):  # outside the dead zone, filters settled
            innovation = residual
            learnt = 1.0
            normal = normal_least + (phi*phi) + forgetting*normal
            moved = theta + phi*residual/normal
            if abs(moved) < K_limit:
                theta = moved
            else:
                theta = (K_limit if moved > 0.0 else (-K_limit))
            weight = 1.0 + forgetting*weight
            mean_square = mean_square + ((residual*residual) - mean_square)/weight
            status = 0.0
            if abs(scale_now*y_now) > validity_limit:
                status = 2.0
        else:
            learnt = 0.0
            innovation = (residual if settle_samples >= waiting else 0.0)
            if weight < 0.5:  # nothing was learnt yet
                theta = pi3_start*(scale_now*scale_now)
                normal = normal_start/((L*L)*(scale_now*scale_now))
        input_2 = input_2 + input_2_now
        input_2_change = input_2_now
        output_2 = output_2 + output_2_now
        output_2_change = output_2_now
    else:
        predicted = last_measured
        expected = 0.0
        innovation = 0.0
        learnt = 0.0
        inverse = (1.0/last_U)
    if theta > K_low:  # no stiffness is zero or less
        estimate = theta
    else:
        estimate = K_low
        if ((status < 2.5) and (status > 1.5)) or (status < 0.5):
            status = 3.0
    pi3 = estimate*(inverse*inverse)
    innovation_variance = (mean_square if (mean_square) > (noise_variance) else noise_variance)  # never below the sensor's share
    if learnt > 0.5:  # nothing was learnt: nothing is known otherwise than before
        information = information + (expected*expected)/innovation_variance
        scatter = innovation_variance/((estimate*estimate)*normal)
        log_variance = (scatter if (scatter) < (variance_limit) else variance_limit)
    information_gained = information
    variance = log_variance
    state[:] = [from_input, from_output, theta, normal, mean_square, weight, information, log_variance, last_input, input_change, input_1, input_1_change, input_2, input_2_change, last_measured, output_change, output_1, output_1_change, output_2, output_2_change, last_U, wait]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance, information_gained, pi3]
