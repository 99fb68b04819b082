"""Regression of the paper for the bicycle: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle, Brennan & Alleyne 2004, eqs 1-4
base: m, L, U
unknown: pi3; in proportion to it: pi4
m1/T = pi1/pi5
m2/T = (pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1))/pi5

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_paper'
OPERATIONS = 80
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ()
REPORTS = True  # outputs are worked out when they are asked for, by a function of their own

CONFIG = (
    ('input_ratio', '(rad/s)/(rad)/(m/s)', 'b1 over a1 + 2: pi1/(L*(pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1)))', 1),
    ('K_per_theta', '(m^2/s^2)/(m/s)', 'L*pi5/(sample_time*(pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1)))', 1),
    ('poles_1', '-', 'first section of the high-pass: 1 + a1 + a2, a2', 2),
    ('poles_2', '-', 'second section of the high-pass: 1 + a1 + a2, a2', 2),
    ('theta_start', 'm/s', 'theta before the first update', 1),
    ('normal_start', '(rad/s)^2/(m/s)^2', 'sum of squared regressors before it, > 0', 1),
    ('normal_least', '(rad/s)^2/(m/s)^2', 'added to it at each update, > 0', 1),
    ('forgetting', '-', 'share of the past kept at each update', 1),
    ('dead_zone', 'rad/s', '|r| that must be exceeded for an update', 1),
    ('settle_samples', '-', 'usable samples in a row until one may update, itself included, 4 or more', 1),
    ('noise_variance', '(rad/s)^2', 'least variance of r a sample, > 0', 1),
    ('theta_low', 'm/s', 'least theta that is reported, > 0', 1),
    ('theta_limit', 'm/s', 'greatest magnitude of theta', 1),
    ('variance_limit', '-', 'greatest variance that is reported', 1),
    ('sample_time', 's', 'sample time the filters are designed for', 1),
    ('dt_room', 's', 'a step that is this much off is not one sample', 1),
    ('U_least', 'm/s', 'least forward speed to learn at, > 0', 1),
    ('input_limit', 'rad', 'greatest believable delta', 1),
    ('output_limit', 'rad/s', 'greatest believable r', 1),
    ('output_jump', 'rad/s', 'greatest believable change of r in one sample', 1),
    ('signal_limit', 'm/s', 'greatest believable scale', 1),
    ('validity_limit', 'm/s^2', "edge of the model's linear range", 1),
)

STATE = (
    ('theta', 'm/s', '(a1 + 2) U, in proportion to K', 1),
    ('normal', '(rad/s)^2/(m/s)^2', 'sum of squared regressors, forgetting', 1),
    ('square_sum', '(rad/s)^2', 'sum of squared residuals, forgetting', 1),
    ('weight', '-', 'updates it rests on, forgetting', 1),
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
    ('wait', '-', 'usable samples until the filters have settled, 0 and less: they have', 1),
    ('residual', 'rad/s', 'by how much the newest output was predicted wrong', 1),
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
    ('pi3', '-', 'group at the last usable scale', 1),
)


def init(config):
    """The flat state before the first sample, from the flat configuration."""
    theta_start = config[6]
    normal_start = config[7]
    settle_samples = config[11]
    noise_variance = config[12]
    U_least = config[18]
    theta = theta_start
    normal = normal_start
    square_sum = noise_variance
    weight = 1.0
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
    last_U = U_least
    wait = settle_samples
    residual = 0.0
    return [theta, normal, square_sum, weight, last_input, input_change, input_1, input_1_change, input_2, input_2_change, last_measured, output_change, output_1, output_1_change, output_2, output_2_change, last_U, wait, residual]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    input_ratio = config[0]
    K_per_theta = config[1]
    poles_1_0 = config[2]
    poles_1_1 = config[3]
    poles_2_0 = config[4]
    poles_2_1 = config[5]
    normal_least = config[8]
    forgetting = config[9]
    dead_zone = config[10]
    settle_samples = config[11]
    noise_variance = config[12]
    theta_low = config[13]
    theta_limit = config[14]
    variance_limit = config[15]
    sample_time = config[16]
    dt_room = config[17]
    U_least = config[18]
    input_limit = config[19]
    output_limit = config[20]
    output_jump = config[21]
    signal_limit = config[22]
    validity_limit = config[23]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    theta = state[0]
    normal = state[1]
    square_sum = state[2]
    weight = state[3]
    last_input = state[4]
    input_change = state[5]
    input_1 = state[6]
    input_1_change = state[7]
    input_2 = state[8]
    input_2_change = state[9]
    last_measured = state[10]
    output_change = state[11]
    output_1 = state[12]
    output_1_change = state[13]
    output_2 = state[14]
    output_2_change = state[15]
    last_U = state[16]
    wait = state[17]
    residual = state[18]
    estimate = 0.0
    innovation = 0.0
    innovation_variance = 0.0
    input_step = 0.0
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
    if abs(dt - sample_time) < dt_room:  # else the sample before is elsewhere
        pass
    else:
        if (dt < 1000000.0) and (dt > 0.0):  # time must advance
            status = 5.0
            waiting = settle_samples
        else:
            status = 7.0
    if status < 6.5:
        if ((abs(last_measured - measured) < output_jump) or (waiting >= settle_samples)) and (abs(measured) < output_limit):  # a missing output is held
            output_step = measured - last_measured
            y_now = measured
        else:
            output_step = 0.0
            y_now = last_measured
            status = 4.0
            waiting = 1.0 + settle_samples
        if (abs(U) < signal_limit) and (abs(input) < input_limit):  # so is an input or a scale
            input_step = input - last_input
            last_input = input
            scale_now = U
        else:
            input_step = 0.0
            scale_now = last_U
            status = 4.0
            waiting = 1.0 + settle_samples
        waiting = waiting - 1.0  # usable samples in a row
        if scale_now <= U_least:  # too slow to see the dynamics
            scale_now = last_U
            waiting = settle_samples
            if status < 1.5:
                status = 6.0
        last_U = scale_now
        last_measured = y_now
        wait = waiting
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
        phi = input_2_change*input_ratio - output_2_change/scale_now  # regressor, eqs 25-26
        y = output_2_now - output_2_change  # second difference, eq 24
        residual = y - phi*theta
        if (abs(y_now) > dead_zone) and (waiting <= 0.0):  # outside the dead zone, filters settled
            normal = normal_least + (phi*phi) + forgetting*normal
            moved = theta + phi*residual/normal
            if abs(moved) < theta_limit:  # as far as any car
                theta = moved
            weight = 1.0 + forgetting*weight
            square_sum = (residual*residual) + forgetting*square_sum
            status = 0.0
            if abs(scale_now*y_now) > validity_limit:
                status = 2.0
            if theta <= theta_low:  # no stiffness is zero or less
                status = 3.0
        input_2 = input_2 + input_2_now
        input_2_change = input_2_now
        output_2 = output_2 + output_2_now
        output_2_change = output_2_now
    else:
        residual = 0.0
    told = (theta if (theta) > (theta_low) else theta_low)  # no stiffness is zero or less
    estimate = K_per_theta*told
    pi3 = estimate/((last_U*last_U))
    mean_square = square_sum/weight
    innovation_variance = (mean_square if (mean_square) > (noise_variance) else noise_variance)  # never below the sensor's share
    scatter = innovation_variance/(normal*(told*told))
    variance = (scatter if (scatter) < (variance_limit) else variance_limit)
    predicted = last_measured - residual
    innovation = (residual if settle_samples > wait else 0.0)
    state[:] = [theta, normal, square_sum, weight, last_input, input_change, input_1, input_1_change, input_2, input_2_change, last_measured, output_change, output_1, output_1_change, output_2, output_2_change, last_U, wait, residual]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance, pi3]
