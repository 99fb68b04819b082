"""First-order regression in a band of the bicycle: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle, Brennan & Alleyne 2004, eqs 1-4
base: m, L, U
unknown: K; frozen: pi1, eta, rho
B1 = -1/(rho*(pi1 - 1))
M2 = -(eta*pi1*rho - eta*pi1 + eta - pi1*rho + pi1 + rho)/(rho*(pi1 - 1))

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_band'
OPERATIONS = 227
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ()
REPORTS = False  # outputs are worked out when they are asked for, by a function of their own

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('pi1', '-', 'frozen a/L, position of the centre of gravity', 1),
    ('eta', '-', 'frozen rear over front cornering coefficient; > 1 understeers', 1),
    ('rho', '-', 'frozen Iz/(m a b), yaw inertia ratio', 1),
    ('sample_time', 's', 'sample time the filters are designed for', 1),
    ('biquad_1', '-', 'section 1, high-pass: b0, b1, b2, a1, a2', 5),
    ('biquad_2', '-', 'section 2, high-pass: b0, b1, b2, a1, a2', 5),
    ('biquad_3', '-', 'section 3, low-pass: b0, b1, b2, a1, a2', 5),
    ('biquad_4', '-', 'section 4, low-pass: b0, b1, b2, a1, a2', 5),
    ('forgetting', '-', 'share of the past kept at each update', 1),
    ('noise_variance', '(rad/s)^2', 'variance of r a sample that is taken out', 1),
    ('noise_zero', '-', 'autocorrelation of the band-pass at lag 0', 1),
    ('noise_one', '-', 'the same at lag 1', 1),
    ('signal_least', '-', 'least share of A that is signal', 1),
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
    ('input_gain', 's', 'B1 times the sample time', 1),
    ('damping', 's', 'M2 times the sample time', 1),
    ('Q', '(rad/s)^2', 'sum of regressor times change', 1),
    ('A', '(rad/s)^2', 'sum of squared regressor', 1),
    ('input_memory', 'rad', 'memory of the sections for delta', 8),
    ('output_memory', 'rad/s', 'memory of the sections for r', 8),
    ('input_before', 'rad', 'filtered delta of the sample before', 1),
    ('output_before', 'rad/s', 'filtered r of the sample before', 1),
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
    K_start = config[30]
    variance_limit = config[39]
    U_least = config[44]
    K = K_start
    input_gain = (-sample_time/(rho*(pi1 - 1.0)))
    damping = (-sample_time*(eta + pi1 + rho + eta*pi1*rho - eta*pi1 - pi1*rho)/(rho*(pi1 - 1.0)))
    Q = 0.0
    A = 0.0
    input_memory_0 = 0.0
    input_memory_1 = 0.0
    input_memory_2 = 0.0
    input_memory_3 = 0.0
    input_memory_4 = 0.0
    input_memory_5 = 0.0
    input_memory_6 = 0.0
    input_memory_7 = 0.0
    output_memory_0 = 0.0
    output_memory_1 = 0.0
    output_memory_2 = 0.0
    output_memory_3 = 0.0
    output_memory_4 = 0.0
    output_memory_5 = 0.0
    output_memory_6 = 0.0
    output_memory_7 = 0.0
    input_before = 0.0
    output_before = 0.0
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
    return [K, input_gain, damping, Q, A, input_memory_0, input_memory_1, input_memory_2, input_memory_3, input_memory_4, input_memory_5, input_memory_6, input_memory_7, output_memory_0, output_memory_1, output_memory_2, output_memory_3, output_memory_4, output_memory_5, output_memory_6, output_memory_7, input_before, output_before, excitation, mean_square, block_score, block_weight, block_age, scatter_sum, scatter_weight, blocks, log_variance, aged, information, last_input, last_measured, last_U, fresh, started]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    L = config[0]
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
    biquad_3_0 = config[15]
    biquad_3_1 = config[16]
    biquad_3_2 = config[17]
    biquad_3_3 = config[18]
    biquad_3_4 = config[19]
    biquad_4_0 = config[20]
    biquad_4_1 = config[21]
    biquad_4_2 = config[22]
    biquad_4_3 = config[23]
    biquad_4_4 = config[24]
    forgetting = config[25]
    noise_variance = config[26]
    noise_zero = config[27]
    noise_one = config[28]
    signal_least = config[29]
    K_low = config[31]
    K_high = config[32]
    excitation_least = config[33]
    excitation_rate = config[34]
    block = config[35]
    block_keep = config[36]
    blocks_most = config[37]
    scatter_low = config[38]
    variance_limit = config[39]
    idle_drift = config[40]
    settle_samples = config[41]
    dt_low = config[42]
    dt_high = config[43]
    U_least = config[44]
    input_limit = config[45]
    output_limit = config[46]
    output_jump = config[47]
    signal_limit = config[48]
    validity_limit = config[49]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    K = state[0]
    input_gain = state[1]
    damping = state[2]
    Q = state[3]
    A = state[4]
    input_memory_0 = state[5]
    input_memory_1 = state[6]
    input_memory_2 = state[7]
    input_memory_3 = state[8]
    input_memory_4 = state[9]
    input_memory_5 = state[10]
    input_memory_6 = state[11]
    input_memory_7 = state[12]
    output_memory_0 = state[13]
    output_memory_1 = state[14]
    output_memory_2 = state[15]
    output_memory_3 = state[16]
    output_memory_4 = state[17]
    output_memory_5 = state[18]
    output_memory_6 = state[19]
    output_memory_7 = state[20]
    input_before = state[21]
    output_before = state[22]
    excitation = state[23]
    mean_square = state[24]
    block_score = state[25]
    block_weight = state[26]
    block_age = state[27]
    scatter_sum = state[28]
    scatter_weight = state[29]
    blocks = state[30]
    log_variance = state[31]
    aged = state[32]
    information = state[33]
    last_input = state[34]
    last_measured = state[35]
    last_U = state[36]
    fresh = state[37]
    started = state[38]
    edge = 0.0
    estimate = 0.0
    excited = 0.0
    information_gained = 0.0
    innovation = 0.0
    innovation_variance = 0.0
    live = 0.0
    predicted = 0.0
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
        at_U = last_U
        inv_U = (1.0/at_U)
        inv_L = (1.0/L)
        input_after_1 = input_memory_0 + biquad_1_0*u_now
        input_memory_0 = input_memory_1 + biquad_1_1*u_now - biquad_1_3*input_after_1
        input_memory_1 = biquad_1_2*u_now - biquad_1_4*input_after_1
        input_after_2 = input_memory_2 + biquad_2_0*input_after_1
        input_memory_2 = input_memory_3 + biquad_2_1*input_after_1 - biquad_2_3*input_after_2
        input_memory_3 = biquad_2_2*input_after_1 - biquad_2_4*input_after_2
        input_after_3 = input_memory_4 + biquad_3_0*input_after_2
        input_memory_4 = input_memory_5 + biquad_3_1*input_after_2 - biquad_3_3*input_after_3
        input_memory_5 = biquad_3_2*input_after_2 - biquad_3_4*input_after_3
        input_filtered = input_memory_6 + biquad_4_0*input_after_3
        input_memory_6 = input_memory_7 + biquad_4_1*input_after_3 - biquad_4_3*input_filtered
        input_memory_7 = biquad_4_2*input_after_3 - biquad_4_4*input_filtered
        output_after_1 = output_memory_0 + biquad_1_0*y_now
        output_memory_0 = output_memory_1 + biquad_1_1*y_now - biquad_1_3*output_after_1
        output_memory_1 = biquad_1_2*y_now - biquad_1_4*output_after_1
        output_after_2 = output_memory_2 + biquad_2_0*output_after_1
        output_memory_2 = output_memory_3 + biquad_2_1*output_after_1 - biquad_2_3*output_after_2
        output_memory_3 = biquad_2_2*output_after_1 - biquad_2_4*output_after_2
        output_after_3 = output_memory_4 + biquad_3_0*output_after_2
        output_memory_4 = output_memory_5 + biquad_3_1*output_after_2 - biquad_3_3*output_after_3
        output_memory_5 = biquad_3_2*output_after_2 - biquad_3_4*output_after_3
        output_filtered = output_memory_6 + biquad_4_0*output_after_3
        output_memory_6 = output_memory_7 + biquad_4_1*output_after_3 - biquad_4_3*output_filtered
        output_memory_7 = biquad_4_2*output_after_3 - biquad_4_4*output_filtered
        from_input = input_gain*(inv_L*inv_L)  # psi per input
        from_output = damping*inv_L*inv_U  # -psi per output
        driven = from_input*input_before
        psi = driven - from_output*output_before
        y = output_filtered - output_before
        residual = y - K*psi
        innovation = (residual if usable > 0.5 else 0.0)
        predicted = y_now - innovation
        drive = K*driven  # what the input alone does to the regression
        excitation = excitation + ((drive*drive) - excitation)*(1.0 if (1.0) < (dt*excitation_rate) else dt*excitation_rate)
        excited = (1.0 if excitation > excitation_least else 0.0)
        if (excited > 0.5) and (fresh > settle_samples) and (live > 0.5):  # the band is excited, the filters settled
            Q = Q*forgetting + psi*y - from_output*noise_variance*(noise_zero - noise_one)
            A = (psi*psi) + A*forgetting - noise_variance*noise_zero*(from_output*from_output)
            noise_sum = noise_variance*noise_zero*(from_output*from_output)/(1.0 - forgetting)  # what noise alone would sum to
            if A > noise_sum*signal_least:  # more than noise
                K = Q/A
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
                if (blocks > 2.5) and (scatter_weight > 0.015625*A):  # enough blocks
                    spread = (scatter_low if (scatter_low) > (scatter_sum/scatter_weight) else scatter_sum/scatter_weight)  # variance of the residual as felt
                    log_variance = (variance_limit if (variance_limit) < (spread*(1.0 + 5.0/blocks)/(A*(K*K))) else spread*(1.0 + 5.0/blocks)/(A*(K*K)))
                    told = (K*K)*(psi*psi)/spread  # by this sample
                    information = information + told
                status = 0.0
                if (last_U*last_U)*(y_now*y_now) > (validity_limit*validity_limit):
                    status = 2.0
                if edge > 0.5:  # the population's edge
                    status = 3.0
        if (excited > 0.5) and (fresh > settle_samples) and (live > 0.5):  # unseen, K may change
            aged = aged*forgetting
        else:
            aged = (variance_limit if (variance_limit) < (aged + dt*idle_drift) else aged + dt*idle_drift)
        input_before = input_filtered
        output_before = output_filtered
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
    state[:] = [K, input_gain, damping, Q, A, input_memory_0, input_memory_1, input_memory_2, input_memory_3, input_memory_4, input_memory_5, input_memory_6, input_memory_7, output_memory_0, output_memory_1, output_memory_2, output_memory_3, output_memory_4, output_memory_5, output_memory_6, output_memory_7, input_before, output_before, excitation, mean_square, block_score, block_weight, block_age, scatter_sum, scatter_weight, blocks, log_variance, aged, information, last_input, last_measured, last_U, fresh, started]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance, information_gained, unknowns]
