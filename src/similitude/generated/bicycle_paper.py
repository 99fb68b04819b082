"""Regression of the paper for the bicycle: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle, Brennan & Alleyne 2004, eqs 1-4
base: m, L, U
unknown: pi3; in proportion to it: pi4
m1/T = pi1/pi5
m2/T = (pi1**2 + pi4_slope*(pi1 - 1)**2 + pi5*(pi4_slope + 1))/pi5

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_paper'
OPERATIONS = 162
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ()

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('pi1', '-', 'frozen pi1', 1),
    ('pi4_slope', '-', 'frozen pi4/pi3', 1),
    ('pi5', '-', 'frozen pi5', 1),
    ('sample_time', 's', 'sample time the filters are designed for', 1),
    ('biquad_1', '-', 'first section: b0, b1, b2, a1, a2 of the high-pass', 5),
    ('biquad_2', '-', 'second section: b0, b1, b2, a1, a2 of the high-pass', 5),
    ('pi3_start', '-', 'pi3 before the first update', 1),
    ('P_start', '-', 'P before the first update', 1),
    ('forgetting', '-', 'share of the past kept at each update', 1),
    ('dead_zone', 'rad/s', '|r| that must be exceeded for an update', 1),
    ('settle_samples', '-', 'whole samples in a row before an update, 3 or more', 1),
    ('noise_variance', '(rad/s)^2', 'least variance of r a sample, > 0', 1),
    ('pi3_low', '-', 'least pi3 that is reported, > 0', 1),
    ('pi3_limit', '-', 'greatest magnitude of pi3', 1),
    ('P_low', '-', 'least P, > 0', 1),
    ('P_high', '-', 'greatest P', 1),
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
    ('m1_rate', '-', 'm1/T', 1),
    ('m2_rate', '-', 'm2/T', 1),
    ('m1', '1/(rad)', 'm1 per physical input at the last usable scale', 1),
    ('m2', '1/(rad/s)', 'm2 per physical output, the same', 1),
    ('unit', 'rad/s', 'output per dimensionless output, the same', 1),
    ('star', '1/(rad/s)', 'its reciprocal', 1),
    ('inv_direct', '-', '1/weight of the newest output in the filter', 1),
    ('inv_forgetting', '-', '1/forgetting factor', 1),
    ('least_spread', '(rad/s)^2', 'least variance of the filtered second difference', 1),
    ('theta', '-', 'pi3 at the last usable scale', 1),
    ('P', '-', 'covariance of theta per residual variance', 1),
    ('mean_square', '-', 'mean square of the residual', 1),
    ('weight', '-', 'updates the mean square rests on', 1),
    ('information', '-', 'information gained about ln K', 1),
    ('input_memory', 'rad', 'memory of both sections for delta', 4),
    ('output_memory', 'rad/s', 'memory of both sections for r', 4),
    ('input_before', 'rad', 'filtered delta, one and two samples ago', 2),
    ('output_before', 'rad/s', 'filtered r, one and two samples ago', 2),
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
    biquad_1_0 = config[5]
    biquad_2_0 = config[10]
    pi3_start = config[15]
    P_start = config[16]
    forgetting = config[17]
    noise_variance = config[20]
    U_least = config[28]
    m1_rate = pi1/pi5
    m2_rate = ((pi1*pi1) + pi4_slope*((pi1 - 1.0)*(pi1 - 1.0)) + pi5*(1.0 + pi4_slope))/pi5
    inv_direct = 1.0/(biquad_1_0*biquad_2_0)
    inv_forgetting = (1.0/forgetting)
    least_spread = noise_variance*(biquad_1_0*biquad_1_0)*(biquad_2_0*biquad_2_0)
    theta = pi3_start
    P = P_start
    mean_square = 0.0
    weight = 0.0
    information = 0.0
    input_memory_0 = 0.0
    input_memory_1 = 0.0
    input_memory_2 = 0.0
    input_memory_3 = 0.0
    output_memory_0 = 0.0
    output_memory_1 = 0.0
    output_memory_2 = 0.0
    output_memory_3 = 0.0
    input_before_0 = 0.0
    input_before_1 = 0.0
    output_before_0 = 0.0
    output_before_1 = 0.0
    last_input = 0.0
    last_measured = 0.0
    last_U = U_least
    fresh = 0.0
    started = 0.0
    unit = last_U/L
    star = L/last_U
    m1 = last_U*m1_rate*sample_time/L  # eq 22, per physical input
    m2 = last_U*m2_rate*sample_time*star/L  # eq 22, per physical output
    return [m1_rate, m2_rate, m1, m2, unit, star, inv_direct, inv_forgetting, least_spread, theta, P, mean_square, weight, information, input_memory_0, input_memory_1, input_memory_2, input_memory_3, output_memory_0, output_memory_1, output_memory_2, output_memory_3, input_before_0, input_before_1, output_before_0, output_before_1, last_input, last_measured, last_U, fresh, started]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    L = config[0]
    sample_time = config[4]
    biquad_1_0 = config[5]
    biquad_1_1 = config[6]
    biquad_1_2 = config[7]
    biquad_1_3 = config[8]
    biquad_1_4 = config[9]
    biquad_2_0 = config[10]
    biquad_2_1 = config[11]
    biquad_2_2 = config[12]
    biquad_2_3 = config[13]
    biquad_2_4 = config[14]
    forgetting = config[17]
    dead_zone = config[18]
    settle_samples = config[19]
    noise_variance = config[20]
    pi3_low = config[21]
    pi3_limit = config[22]
    P_low = config[23]
    P_high = config[24]
    variance_limit = config[25]
    dt_low = config[26]
    dt_high = config[27]
    U_least = config[28]
    input_limit = config[29]
    output_limit = config[30]
    output_jump = config[31]
    signal_limit = config[32]
    validity_limit = config[33]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    m1_rate = state[0]
    m2_rate = state[1]
    m1 = state[2]
    m2 = state[3]
    unit = state[4]
    star = state[5]
    inv_direct = state[6]
    inv_forgetting = state[7]
    least_spread = state[8]
    theta = state[9]
    P = state[10]
    mean_square = state[11]
    weight = state[12]
    information = state[13]
    input_memory_0 = state[14]
    input_memory_1 = state[15]
    input_memory_2 = state[16]
    input_memory_3 = state[17]
    output_memory_0 = state[18]
    output_memory_1 = state[19]
    output_memory_2 = state[20]
    output_memory_3 = state[21]
    input_before_0 = state[22]
    input_before_1 = state[23]
    output_before_0 = state[24]
    output_before_1 = state[25]
    last_input = state[26]
    last_measured = state[27]
    last_U = state[28]
    fresh = state[29]
    started = state[30]
    estimate = 0.0
    information_gained = 0.0
    innovation = 0.0
    innovation_variance = 0.0
    live = 0.0
    pi3 = 0.0
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
                if started > 0.5:  # the same constant
                    ratio = (last_U*last_U)/((scale_now*scale_now))  # of pi3 for the same K
                    theta = ratio*theta
                    P = P*(ratio*ratio)
                last_U = scale_now
                unit = last_U/L
                star = L/last_U
                m1 = last_U*m1_rate*sample_time/L  # eq 22, per physical input
                m2 = last_U*m2_rate*sample_time*star/L  # eq 22, per physical output
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
        phi = m1*(input_before_0 - input_before_1) + m2*(output_before_1 - output_before_0)  # regressor, eqs 25-26
        filtered = 2.0*output_before_0 + phi*theta*unit - output_before_1  # filtered output predicted
        rest = output_memory_2 + biquad_2_0*output_memory_0  # filtered output if the newest were zero
        predicted = inv_direct*(filtered - rest)
        if usable > 0.5:
            innovation = y_now - predicted
        input_half = input_memory_0 + biquad_1_0*u_now
        input_memory_0 = input_memory_1 + biquad_1_1*u_now - biquad_1_3*input_half
        input_memory_1 = biquad_1_2*u_now - biquad_1_4*input_half
        input_filtered = input_memory_2 + biquad_2_0*input_half
        input_memory_2 = input_memory_3 + biquad_2_1*input_half - biquad_2_3*input_filtered
        input_memory_3 = biquad_2_2*input_half - biquad_2_4*input_filtered
        output_half = output_memory_0 + biquad_1_0*y_now
        output_memory_0 = output_memory_1 + biquad_1_1*y_now - biquad_1_3*output_half
        output_memory_1 = biquad_1_2*y_now - biquad_1_4*output_half
        output_filtered = output_memory_2 + biquad_2_0*output_half
        output_memory_2 = output_memory_3 + biquad_2_1*output_half - biquad_2_3*output_filtered
        output_memory_3 = biquad_2_2*output_half - biquad_2_4*output_filtered
        y = star*(output_before_1 + output_filtered - 2.0*output_before_0)  # second difference, eq 24
        if ((y_now < (-dead_zone)) or (y_now > dead_zone)) and (fresh > settle_samples) and (live > 0.5):  # outside the dead zone, filters settled
            residual = y - phi*theta
            gain = P*phi/((forgetting + P*(phi*phi)))
            weight = 1.0 + forgetting*weight
            mean_square = mean_square + ((residual*residual) - mean_square)/weight
            spread = (mean_square if (mean_square) > (least_spread*(star*star)) else least_spread*(star*star))  # never below the sensor's share
            information = information + (phi*phi)*(theta*theta)/spread
            theta = theta + gain*residual
            theta = (pi3_limit if (pi3_limit) < (theta) else theta)
            theta = ((-pi3_limit) if ((-pi3_limit)) > (theta) else theta)
            P = P*inv_forgetting*(1.0 - gain*phi)
            P = (P if (P) < (P_high) else P_high)
            P = (P if (P) > (P_low) else P_low)
            status = 0.0
            if (last_U*last_U)*(y_now*y_now) > (validity_limit*validity_limit):
                status = 2.0
            if theta <= pi3_low:  # no stiffness is zero or less
                status = 3.0
        output_before_1 = output_before_0
        output_before_0 = output_filtered
        input_before_1 = input_before_0
        input_before_0 = input_filtered
        last_input = u_now
        last_measured = y_now
    else:
        status = 7.0
    pi3 = (pi3_low if (pi3_low) > (theta) else theta)
    estimate = pi3*(last_U*last_U)
    raw = inv_direct*unit  # raw output per dimensionless residual
    innovation_variance = (noise_variance if (noise_variance) > (mean_square*(raw*raw)) else mean_square*(raw*raw))
    variance = variance_limit
    if weight > 0.5:
        scatter = P*innovation_variance/((pi3*pi3)*(raw*raw))
        variance = (scatter if (scatter) < (variance_limit) else variance_limit)
    information_gained = information
    state[:] = [m1_rate, m2_rate, m1, m2, unit, star, inv_direct, inv_forgetting, least_spread, theta, P, mean_square, weight, information, input_memory_0, input_memory_1, input_memory_2, input_memory_3, output_memory_0, output_memory_1, output_memory_2, output_memory_3, input_before_0, input_before_1, output_before_0, output_before_1, last_input, last_measured, last_U, fresh, started]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance, information_gained, pi3]
