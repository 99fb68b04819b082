"""Four-unknown regression behind state-variable filters of the bicycle: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle, Brennan & Alleyne 2004, eqs 1-4
base: m, L, U
unknown: K; frozen: pi1, eta, rho
B1 = -1/(rho*(pi1 - 1))
M2 = -(eta*pi1*rho - eta*pi1 + eta - pi1*rho + pi1 + rho)/(rho*(pi1 - 1))
K1 = -(eta - 1)/(rho*(pi1 - 1))
K2 = eta/(rho*(pi1 - 1)**2), G2 = eta/(rho*(pi1 - 1)**2)

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_robust'
OPERATIONS = 638
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ()
REPORTS = False  # outputs are worked out when they are asked for, by a function of their own

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('pi1', '-', 'frozen a/L, position of the centre of gravity', 1),
    ('eta', '-', 'frozen rear over front cornering coefficient; > 1 understeers', 1),
    ('rho', '-', 'frozen Iz/(m a b), yaw inertia ratio', 1),
    ('sample_time', 's', 'sample time the filters are designed for', 1),
    ('corner', '1/s', 'corner of the four stages', 1),
    ('offset_rate', '1/s', 'rate at which offsets are followed and taken out', 1),
    ('forgetting', '-', 'share of the past kept at each update', 1),
    ('noise_variance', '(rad/s)^2', 'variance of r a sample that is taken out', 1),
    ('noise_value', '-', 'moment of filtered unit noise: value', 1),
    ('noise_rate', '-', 'moment of filtered unit noise: rate', 1),
    ('noise_change', '-', 'moment of filtered unit noise: change', 1),
    ('noise_value_rate', '-', 'moment of filtered unit noise: value_rate', 1),
    ('noise_value_change', '-', 'moment of filtered unit noise: value_change', 1),
    ('noise_rate_change', '-', 'moment of filtered unit noise: rate_change', 1),
    ('signal_least', '-', 'least pivot of four against the noise taken out of it', 1),
    ('signal_least_one', '-', 'the same of one unknown', 1),
    ('pivot_least', '-', 'least share of a regressor that the others must not explain', 1),
    ('move_limit', '-', 'greatest move of ln K in one sample with one unknown', 1),
    ('K_start', 'm^2/s^2', 'K before the first update', 1),
    ('K_low', 'm^2/s^2', 'least K of the population', 1),
    ('K_high', 'm^2/s^2', 'greatest K of the population', 1),
    ('excitation_least', '-', 'least mean square of the drive to learn from, in its units', 1),
    ('excitation_rate', '1/s', 'averaging rate of that mean square', 1),
    ('block', 's', 'length of a block of the scatter', 1),
    ('block_keep', '-', 'share of the older blocks kept at each new one', 1),
    ('blocks_most', '-', 'blocks remembered', 1),
    ('scatter_low', '-', 'least variance of the residual, in its units, > 0', 1),
    ('variance_limit', '-', 'greatest variance that is reported', 1),
    ('idle_drift', '1/s', 'growth of the variance while nothing is learnt', 1),
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
    ('input_gain', '-', 'B1', 1),
    ('damping', '-', 'M2', 1),
    ('stiffness', '-', 'K1', 1),
    ('pair_output', '-', 'K2', 1),
    ('pair_input', '-', 'G2', 1),
    ('stage_keep', '-', "weight of a stage's own past", 1),
    ('stage_share', '-', 'weight of each end of what comes in', 1),
    ('input_offset', 'rad', 'slow part of delta', 1),
    ('output_offset', 'rad/s', 'slow part of r', 1),
    ('input_stage', 'rad', 'delta and its four stages', 5),
    ('output_stage', 'rad/s', 'r and its four stages', 5),
    ('scale_stage', 'm/s', 'forward speed as late as the stages are', 1),
    ('A', '-', 'normal matrix, unknowns 2, 3, 4, 1, upper triangle by rows', 10),
    ('q', '-', 'right-hand side, unknowns 2, 3, 4, 1', 4),
    ('yy', '-', 'sum of squares of the left side', 1),
    ('weight', '-', 'samples the sums rest on', 1),
    ('excitation', '-', 'mean square of the drive, in its units', 1),
    ('mean_square', '-', 'mean square of the innovation, in its units', 1),
    ('block_score', '-', 'sum of regressor times residual over this block', 1),
    ('block_weight', '-', 'sum of squared regressor over this block', 1),
    ('block_age', 's', 'age of this block', 1),
    ('scatter_sum', '-', 'squared scores of the blocks remembered', 1),
    ('scatter_weight', '-', 'their weights', 1),
    ('blocks', '-', 'how many there are', 1),
    ('log_variance', '-', 'variance of ln K from the scatter', 1),
    ('aged', '-', 'variance grown while nothing was learnt', 1),
    ('information', '-', 'information gained about ln K', 1),
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
    ('unknowns', '-', 'unknowns the excitation carries now; 0 while nothing is learnt', 1),
)


def init(config):
    """The flat state before the first sample, from the flat configuration."""
    pi1 = config[1]
    eta = config[2]
    rho = config[3]
    sample_time = config[4]
    corner = config[5]
    K_start = config[19]
    variance_limit = config[28]
    U_least = config[33]
    K = K_start
    input_gain = (-1.0/(rho*(pi1 - 1.0)))
    damping = (-(eta + pi1 + rho + eta*pi1*rho - eta*pi1 - pi1*rho)/(rho*(pi1 - 1.0)))
    stiffness = (-(eta - 1.0)/(rho*(pi1 - 1.0)))
    pair_output = eta/(rho*((pi1 - 1.0)*(pi1 - 1.0)))
    pair_input = eta/(rho*((pi1 - 1.0)*(pi1 - 1.0)))
    stage_keep = (2.0 - corner*sample_time)/((2.0 + corner*sample_time))
    stage_share = corner*sample_time/((2.0 + corner*sample_time))
    input_offset = 0.0
    output_offset = 0.0
    input_stage_0 = 0.0
    input_stage_1 = 0.0
    input_stage_2 = 0.0
    input_stage_3 = 0.0
    input_stage_4 = 0.0
    output_stage_0 = 0.0
    output_stage_1 = 0.0
    output_stage_2 = 0.0
    output_stage_3 = 0.0
    output_stage_4 = 0.0
    scale_stage = U_least
    A_0 = 0.0
    A_1 = 0.0
    A_2 = 0.0
    A_3 = 0.0
    A_4 = 0.0
    A_5 = 0.0
    A_6 = 0.0
    A_7 = 0.0
    A_8 = 0.0
    A_9 = 0.0
    q_0 = 0.0
    q_1 = 0.0
    q_2 = 0.0
    q_3 = 0.0
    yy = 0.0
    weight = 0.0
    excitation = 0.0
    mean_square = 0.0
    block_score = 0.0
    block_weight = 0.0
    block_age = 0.0
    scatter_sum = 0.0
    scatter_weight = 0.0
    blocks = (-1.0)
    log_variance = variance_limit
    aged = 0.0
    information = 0.0
    last_input = 0.0
    last_measured = 0.0
    last_U = U_least
    fresh = 0.0
    started = 0.0
    return [K, input_gain, damping, stiffness, pair_output, pair_input, stage_keep, stage_share, input_offset, output_offset, input_stage_0, input_stage_1, input_stage_2, input_stage_3, input_stage_4, output_stage_0, output_stage_1, output_stage_2, output_stage_3, output_stage_4, scale_stage, A_0, A_1, A_2, A_3, A_4, A_5, A_6, A_7, A_8, A_9, q_0, q_1, q_2, q_3, yy, weight, excitation, mean_square, block_score, block_weight, block_age, scatter_sum, scatter_weight, blocks, log_variance, aged, information, last_input, last_measured, last_U, fresh, started]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    L = config[0]
    sample_time = config[4]
    corner = config[5]
    offset_rate = config[6]
    forgetting = config[7]
    noise_variance = config[8]
    noise_value = config[9]
    noise_rate = config[10]
    noise_change = config[11]
    noise_value_rate = config[12]
    noise_value_change = config[13]
    noise_rate_change = config[14]
    signal_least = config[15]
    signal_least_one = config[16]
    pivot_least = config[17]
    move_limit = config[18]
    K_start = config[19]
    K_low = config[20]
    K_high = config[21]
    excitation_least = config[22]
    excitation_rate = config[23]
    block = config[24]
    block_keep = config[25]
    blocks_most = config[26]
    scatter_low = config[27]
    variance_limit = config[28]
    idle_drift = config[29]
    settle_samples = config[30]
    dt_low = config[31]
    dt_high = config[32]
    U_least = config[33]
    input_limit = config[34]
    output_limit = config[35]
    output_jump = config[36]
    signal_limit = config[37]
    validity_limit = config[38]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    K = state[0]
    input_gain = state[1]
    damping = state[2]
    stiffness = state[3]
    pair_output = state[4]
    pair_input = state[5]
    stage_keep = state[6]
    stage_share = state[7]
    input_offset = state[8]
    output_offset = state[9]
    input_stage_0 = state[10]
    input_stage_1 = state[11]
    input_stage_2 = state[12]
    input_stage_3 = state[13]
    input_stage_4 = state[14]
    output_stage_0 = state[15]
    output_stage_1 = state[16]
    output_stage_2 = state[17]
    output_stage_3 = state[18]
    output_stage_4 = state[19]
    scale_stage = state[20]
    A_0 = state[21]
    A_1 = state[22]
    A_2 = state[23]
    A_3 = state[24]
    A_4 = state[25]
    A_5 = state[26]
    A_6 = state[27]
    A_7 = state[28]
    A_8 = state[29]
    A_9 = state[30]
    q_0 = state[31]
    q_1 = state[32]
    q_2 = state[33]
    q_3 = state[34]
    yy = state[35]
    weight = state[36]
    excitation = state[37]
    mean_square = state[38]
    block_score = state[39]
    block_weight = state[40]
    block_age = state[41]
    scatter_sum = state[42]
    scatter_weight = state[43]
    blocks = state[44]
    log_variance = state[45]
    aged = state[46]
    information = state[47]
    last_input = state[48]
    last_measured = state[49]
    last_U = state[50]
    fresh = state[51]
    started = state[52]
    carried = 0.0
    edge = 0.0
    estimate = 0.0
    excited = 0.0
    information_gained = 0.0
    innovation = 0.0
    innovation_variance = 0.0
    live = 0.0
    lowest = 0.0
    predicted = 0.0
    residual = 0.0
    scale_now = 0.0
    spread = 0.0
    status = 0.0
    u_now = 0.0
    unknowns = 0.0
    usable = 0.0
    variance = 0.0
    y_now = 0.0
    predicted = last_measured
    innovation = 0.0
    unknowns = 0.0
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
        inv_L = (1.0/L)
        slowly = (1.0 if (1.0) < (dt*offset_rate) else dt*offset_rate)
        input_offset = input_offset + slowly*(u_now - input_offset)
        output_offset = output_offset + slowly*(y_now - output_offset)
        input_0 = u_now - input_offset
        output_0 = y_now - output_offset
        input_1 = input_stage_1*stage_keep + stage_share*(input_0 + input_stage_0)
        input_stage_0 = input_0
        input_2 = input_stage_2*stage_keep + stage_share*(input_1 + input_stage_1)
        input_stage_1 = input_1
        input_3 = input_stage_3*stage_keep + stage_share*(input_2 + input_stage_2)
        input_stage_2 = input_2
        input_4 = input_stage_4*stage_keep + stage_share*(input_3 + input_stage_3)
        input_stage_3 = input_3
        input_stage_4 = input_4
        output_1 = output_stage_1*stage_keep + stage_share*(output_0 + output_stage_0)
        output_stage_0 = output_0
        output_2 = output_stage_2*stage_keep + stage_share*(output_1 + output_stage_1)
        output_stage_1 = output_1
        output_3 = output_stage_3*stage_keep + stage_share*(output_2 + output_stage_2)
        output_stage_2 = output_2
        output_4 = output_stage_4*stage_keep + stage_share*(output_3 + output_stage_3)
        output_stage_3 = output_3
        output_stage_4 = output_4
        scale_stage = (scale_stage + 0.25*corner*sample_time*(last_U - scale_stage) if fresh > settle_samples else last_U)  # as late as the filtered signals
        late = (1.0/scale_stage)
        to_input = input_gain*(inv_L*inv_L)
        to_rate = damping*inv_L*late
        to_output = (inv_L*inv_L)
        to_pair = pair_output*(inv_L*inv_L)*(late*late)
        psi_1 = corner*to_input*(input_3 - input_4)
        psi_2 = (-corner*to_rate*(output_3 - output_4))
        psi_3 = (-output_4*to_output)
        psi_4 = input_4*late*pair_input*(inv_L*inv_L*inv_L) - output_4*to_pair
        y = (corner*corner)*(output_2 + output_4 - 2.0*output_3)  # second derivative
        carried = 0.0
        drive = K*psi_1  # what the input alone does to the regression
        excitation = excitation + ((drive*drive) - excitation)*(1.0 if (1.0) < (dt*excitation_rate) else dt*excitation_rate)
        excited = (1.0 if excitation > excitation_least else 0.0)
        together = K*psi_1 + K*psi_2 + psi_4*(K*K) + K*psi_3*stiffness  # of the car with this K
        residual = y - together
        if (excited > 0.5) and (fresh > settle_samples) and (live > 0.5):  # the steer moves, the filters have settled
            weight = 1.0 + forgetting*weight
            A_0 = (psi_2*psi_2) + A_0*forgetting - noise_rate*noise_variance*(to_rate*to_rate)
            A_1 = A_1*forgetting + psi_2*psi_3 - noise_value_rate*noise_variance*to_output*to_rate
            A_2 = A_2*forgetting + psi_2*psi_4 - noise_value_rate*noise_variance*to_pair*to_rate
            A_3 = A_3*forgetting + psi_1*psi_2
            A_4 = (psi_3*psi_3) + A_4*forgetting - noise_value*noise_variance*(to_output*to_output)
            A_5 = A_5*forgetting + psi_3*psi_4 - noise_value*noise_variance*to_output*to_pair
            A_6 = A_6*forgetting + psi_1*psi_3
            A_7 = (psi_4*psi_4) + A_7*forgetting - noise_value*noise_variance*(to_pair*to_pair)
            A_8 = A_8*forgetting + psi_1*psi_4
            A_9 = (psi_1*psi_1) + A_9*forgetting
            q_0 = forgetting*q_0 + psi_2*y + noise_rate_change*noise_variance*to_rate
            q_1 = forgetting*q_1 + psi_3*y + noise_value_change*noise_variance*to_output
            q_2 = forgetting*q_2 + psi_4*y + noise_value_change*noise_variance*to_pair
            q_3 = forgetting*q_3 + psi_1*y
            yy = (y*y) + forgetting*yy - noise_change*noise_variance
            noise_sum = noise_variance*weight  # the noise's share of the sums
            d_0 = A_0
            if d_0 > (A_0*pivot_least if (A_0*pivot_least) > (noise_rate*noise_sum*signal_least*(to_rate*to_rate)) else noise_rate*noise_sum*signal_least*(to_rate*to_rate)):
                inv_d_0 = (1.0/d_0)
                z_0 = q_0
                w_0 = psi_2
                part_0 = inv_d_0*w_0*z_0
                u_10 = A_1
                l_10 = inv_d_0*u_10
                d_1 = A_4 - l_10*u_10
                if d_1 > (A_4*pivot_least if (A_4*pivot_least) > (noise_sum*noise_value*signal_least*(to_output*to_output)) else noise_sum*noise_value*signal_least*(to_output*to_output)):
                    inv_d_1 = (1.0/d_1)
                    z_1 = q_1 - l_10*z_0
                    w_1 = psi_3 - l_10*w_0
                    part_1 = inv_d_1*w_1*z_1
                    u_20 = A_2
                    l_20 = inv_d_0*u_20
                    u_21 = A_5 - l_20*u_10
                    l_21 = inv_d_1*u_21
                    d_2 = A_7 - l_20*u_20 - l_21*u_21
                    if d_2 > (A_7*pivot_least if (A_7*pivot_least) > (noise_sum*noise_value*signal_least*(to_pair*to_pair)) else noise_sum*noise_value*signal_least*(to_pair*to_pair)):
                        inv_d_2 = (1.0/d_2)
                        z_2 = q_2 - l_20*z_0 - l_21*z_1
                        w_2 = psi_4 - l_20*w_0 - l_21*w_1
                        part_2 = inv_d_2*w_2*z_2
                        u_30 = A_3
                        l_30 = inv_d_0*u_30
                        u_31 = A_6 - l_30*u_10
                        l_31 = inv_d_1*u_31
                        u_32 = A_8 - l_30*u_20 - l_31*u_21
                        l_32 = inv_d_2*u_32
                        d_3 = A_9 - l_30*u_30 - l_31*u_31 - l_32*u_32
                        if d_3 > (0.0 if (0.0) > (A_9*pivot_least) else A_9*pivot_least):  # every unknown is carried
                            inv_d_3 = (1.0/d_3)
                            z_3 = q_3 - l_30*z_0 - l_31*z_1 - l_32*z_2
                            w_3 = psi_1 - l_30*w_0 - l_31*w_1 - l_32*w_2
                            part_3 = inv_d_3*w_3*z_3
                            K = inv_d_3*z_3
                            edge = 0.0
                            if (K < K_low) or (K > K_high):  # no car is softer or stiffer
                                K = (K if (K) > (K_low) else K_low)
                                K = (K if (K) < (K_high) else K_high)
                                edge = 1.0
                            carried = 4.0
                            unknowns = 4.0
                            residual = y - part_0 - part_1 - part_2 - part_3
                            block_score = block_score + residual*w_3
                            block_weight = block_weight + (w_3*w_3)
                            block_age = block_age + dt
                            if block_age >= block:  # the block is full
                                counted = (1.0 if blocks > (-0.5) else 0.0)  # not the first
                                scatter_sum = counted*((block_score*block_score) + block_keep*scatter_sum)
                                scatter_weight = counted*(block_weight + block_keep*scatter_weight)
                                blocks = (blocks_most if (blocks_most) < (1.0 + blocks) else 1.0 + blocks)
                                block_score = 0.0
                                block_weight = 0.0
                                block_age = 0.0
                            if (blocks > 2.5) and (scatter_weight > 0.015625*d_3):  # enough blocks
                                spread = (scatter_low if (scatter_low) > (scatter_sum/scatter_weight) else scatter_sum/scatter_weight)  # variance of the residual as felt
                                log_variance = (variance_limit if (variance_limit) < (spread*(1.0 + 5.0/blocks)/((K*K)*d_3)) else spread*(1.0 + 5.0/blocks)/((K*K)*d_3))
                                told = (K*K)*(w_3*w_3)/spread  # by this sample
                                information = information + told
                            status = 0.0
                            if (last_U*last_U)*(y_now*y_now) > (validity_limit*validity_limit):
                                status = 2.0
                            if edge > 0.5:  # the population's edge
                                status = 3.0
            if carried < 0.5:  # the steer says less
                c2 = A_0 + 2.0*A_3 + A_9 + 2.0*A_1*stiffness + A_4*(stiffness*stiffness) + 2.0*A_6*stiffness
                c3 = A_2 + A_8 + A_5*stiffness
                c4 = A_7
                d1 = q_0 + q_3 + q_1*stiffness
                d2 = q_2
                lowest = yy + K*(K*(c2 + K*(2.0*c3 + K*c4) - 2.0*d2) - 2.0*d1)
                place_0 = 0.5*K_start
                cost_0 = yy + place_0*(place_0*(c2 + place_0*(2.0*c3 + c4*place_0) - 2.0*d2) - 2.0*d1)
                if cost_0*(K*K) < lowest*(place_0*place_0):  # another valley
                    K = place_0
                    lowest = cost_0
                place_1 = 0.7*K_start
                cost_1 = yy + place_1*(place_1*(c2 + place_1*(2.0*c3 + c4*place_1) - 2.0*d2) - 2.0*d1)
                if cost_1*(K*K) < lowest*(place_1*place_1):
                    K = place_1
                    lowest = cost_1
                place_2 = K_start
                cost_2 = yy + place_2*(place_2*(c2 + place_2*(2.0*c3 + c4*place_2) - 2.0*d2) - 2.0*d1)
                if cost_2*(K*K) < lowest*(place_2*place_2):
                    K = place_2
                    lowest = cost_2
                place_3 = 1.4*K_start
                cost_3 = yy + place_3*(place_3*(c2 + place_3*(2.0*c3 + c4*place_3) - 2.0*d2) - 2.0*d1)
                if cost_3*(K*K) < lowest*(place_3*place_3):
                    K = place_3
                    lowest = cost_3
                place_4 = 2.0*K_start
                cost_4 = yy + place_4*(place_4*(c2 + place_4*(2.0*c3 + c4*place_4) - 2.0*d2) - 2.0*d1)
                if cost_4*(K*K) < lowest*(place_4*place_4):
                    K = place_4
                    lowest = cost_4
                slow = 2.0*K*to_pair + stiffness*to_output
                noise_along = noise_value*(slow*slow) + to_rate*(noise_rate*to_rate + 2.0*noise_value_rate*slow)
                psi = psi_1 + psi_2 + 2.0*K*psi_4 + psi_3*stiffness
                normal = c2 + 4.0*K*(c3 + K*c4)
                wanted = d1 - K*(c2 + K*(3.0*c3 + 2.0*K*c4) - 2.0*d2)
                if (normal > 0.0) and (normal > noise_along*noise_sum*signal_least_one):  # more than noise
                    K = K + ((-K*move_limit) if ((-K*move_limit)) > ((K*move_limit if (K*move_limit) < (wanted/normal) else wanted/normal)) else (K*move_limit if (K*move_limit) < (wanted/normal) else wanted/normal))
                    edge = 0.0
                    if (K < K_low) or (K > K_high):  # no car is softer or stiffer
                        K = (K if (K) > (K_low) else K_low)
                        K = (K if (K) < (K_high) else K_high)
                        edge = 1.0
                    unknowns = 1.0
                    block_score = block_score + psi*residual
                    block_weight = block_weight + (psi*psi)
                    block_age = block_age + dt
                    if block_age >= block:  # the block is full
                        counted = (1.0 if blocks > (-0.5) else 0.0)  # not the first
                        scatter_sum = counted*((block_score*block_score) + block_keep*scatter_sum)
                        scatter_weight = counted*(block_weight + block_keep*scatter_weight)
                        blocks = (blocks_most if (blocks_most) < (1.0 + blocks) else 1.0 + blocks)
                        block_score = 0.0
                        block_weight = 0.0
                        block_age = 0.0
                    if (blocks > 2.5) and (scatter_weight > 0.015625*normal):  # enough blocks
                        spread = (scatter_low if (scatter_low) > (scatter_sum/scatter_weight) else scatter_sum/scatter_weight)  # variance of the residual as felt
                        log_variance = (variance_limit if (variance_limit) < (spread*(1.0 + 5.0/blocks)/((K*K)*normal)) else spread*(1.0 + 5.0/blocks)/((K*K)*normal))
                        told = (K*K)*(psi*psi)/spread  # by this sample
                        information = information + told
                    status = 0.0
                    if (last_U*last_U)*(y_now*y_now) > (validity_limit*validity_limit):
                        status = 2.0
                    if edge > 0.5:  # the population's edge
                        status = 3.0
        innovation = (residual/corner if usable > 0.5 else 0.0)
        predicted = y_now - innovation
        if (excited > 0.5) and (fresh > settle_samples) and (live > 0.5):  # unseen, K may change
            aged = aged*forgetting
        else:
            aged = (variance_limit if (variance_limit) < (aged + dt*idle_drift) else aged + dt*idle_drift)
        if usable > 0.5:
            mean_square = mean_square + ((innovation*innovation) - mean_square)*(1.0 if (1.0) < (dt*excitation_rate) else dt*excitation_rate)
        last_input = u_now
        last_measured = y_now
    else:
        status = 7.0
    innovation_variance = (mean_square if (mean_square) > (scatter_low) else scatter_low)
    estimate = K
    variance = (variance_limit if (variance_limit) < (aged + log_variance) else aged + log_variance)
    information_gained = information
    state[:] = [K, input_gain, damping, stiffness, pair_output, pair_input, stage_keep, stage_share, input_offset, output_offset, input_stage_0, input_stage_1, input_stage_2, input_stage_3, input_stage_4, output_stage_0, output_stage_1, output_stage_2, output_stage_3, output_stage_4, scale_stage, A_0, A_1, A_2, A_3, A_4, A_5, A_6, A_7, A_8, A_9, q_0, q_1, q_2, q_3, yy, weight, excitation, mean_square, block_score, block_weight, block_age, scatter_sum, scatter_weight, blocks, log_variance, aged, information, last_input, last_measured, last_U, fresh, started]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance, information_gained, unknowns]
