"""Recursive prediction error method of the bicycle: layout and scalar twin. Generated from its model by similitude; do not edit.

model: bicycle, Brennan & Alleyne 2004, eqs 1-4
base: m, L, U
unknown: K; frozen: pi1, eta, rho
one implicit step a sample: similitude.sampling

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = 'bicycle_output_error'
OPERATIONS = 393
STATUS = {'ok': 0, 'not_excited': 1, 'outside_linear': 2, 'at_limit': 3, 'no_measurement': 4, 'restarted': 5, 'too_slow': 6, 'bad_sample': 7}
COORDINATES = ()
REPORTS = False  # outputs are worked out when they are asked for, by a function of their own

CONFIG = (
    ('L', 'm', 'wheelbase', 1),
    ('pi1', '-', 'frozen a/L, position of the centre of gravity', 1),
    ('eta', '-', 'frozen rear over front cornering coefficient; > 1 understeers', 1),
    ('rho', '-', 'frozen Iz/(m a b), yaw inertia ratio', 1),
    ('forgetting_rate', '1/s', 'rate at which the past is forgotten', 1),
    ('noise_variance', '(rad/s)^2', 'variance of r a sample, > 0', 1),
    ('start_variance', '-', 'variance of ln K before the first update, > 0', 1),
    ('observer_rate', '1/s', 'pull of the model towards the measurement', 1),
    ('observer_margin', '1/s^2', 'stiffness of the motion below which the pull is raised', 1),
    ('offset_rate', '1/s', 'rate at which offsets are followed and taken out', 1),
    ('state_limit', '-', 'greatest dimensionless state', 1),
    ('move_limit', '-', 'greatest move of ln K in one sample', 1),
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
    ('v_star', '-', 'dimensionless state of the model', 1),
    ('r_star', '-', 'dimensionless state of the model', 1),
    ('v_star_slope', '-', 'its sensitivity to the logarithm', 1),
    ('r_star_slope', '-', 'its sensitivity to the logarithm', 1),
    ('damping', '-', 'M2', 1),
    ('stiffness', '-', 'K1', 1),
    ('pair_output', '-', 'K2', 1),
    ('scale_before', 'm/s', 'scale of the sample before', 1),
    ('A', '(rad/s)^2', 'sum of squared sensitivity', 1),
    ('error_offset', 'rad/s', 'slow part of the error', 1),
    ('slope_offset', 'rad/s', 'slow part of the sensitivity', 1),
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
    noise_variance = config[5]
    start_variance = config[6]
    K_start = config[12]
    variance_limit = config[21]
    U_least = config[26]
    K = K_start
    v_star = 0.0
    r_star = 0.0
    v_star_slope = 0.0
    r_star_slope = 0.0
    damping = (-(eta + pi1 + rho + eta*pi1*rho - eta*pi1 - pi1*rho)/(rho*(pi1 - 1.0)))
    stiffness = (-(eta - 1.0)/(rho*(pi1 - 1.0)))
    pair_output = eta/(rho*((pi1 - 1.0)*(pi1 - 1.0)))
    scale_before = U_least
    A = noise_variance/start_variance
    error_offset = 0.0
    slope_offset = 0.0
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
    return [K, v_star, r_star, v_star_slope, r_star_slope, damping, stiffness, pair_output, scale_before, A, error_offset, slope_offset, excitation, mean_square, block_score, block_weight, block_age, scatter_sum, scatter_weight, blocks, log_variance, aged, information, last_input, last_measured, last_U, fresh, started]


def step(config, state, sample):
    """One sample on the flat state, changed in place; returns (status, flat output)."""
    L = config[0]
    pi1 = config[1]
    eta = config[2]
    rho = config[3]
    forgetting_rate = config[4]
    observer_rate = config[7]
    observer_margin = config[8]
    offset_rate = config[9]
    state_limit = config[10]
    move_limit = config[11]
    K_low = config[13]
    K_high = config[14]
    excitation_least = config[15]
    excitation_rate = config[16]
    block = config[17]
    block_keep = config[18]
    blocks_most = config[19]
    scatter_low = config[20]
    variance_limit = config[21]
    idle_drift = config[22]
    settle_samples = config[23]
    dt_low = config[24]
    dt_high = config[25]
    U_least = config[26]
    input_limit = config[27]
    output_limit = config[28]
    output_jump = config[29]
    signal_limit = config[30]
    validity_limit = config[31]
    dt = sample[0]
    input = sample[1]
    U = sample[2]
    measured = sample[3]
    K = state[0]
    v_star = state[1]
    r_star = state[2]
    v_star_slope = state[3]
    r_star_slope = state[4]
    damping = state[5]
    stiffness = state[6]
    pair_output = state[7]
    scale_before = state[8]
    A = state[9]
    error_offset = state[10]
    slope_offset = state[11]
    excitation = state[12]
    mean_square = state[13]
    block_score = state[14]
    block_weight = state[15]
    block_age = state[16]
    scatter_sum = state[17]
    scatter_weight = state[18]
    blocks = state[19]
    log_variance = state[20]
    aged = state[21]
    information = state[22]
    last_input = state[23]
    last_measured = state[24]
    last_U = state[25]
    fresh = state[26]
    started = state[27]
    anew = 0.0
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
        anew = 0.0
        if (r_star < (-state_limit)) or (r_star > state_limit) or (v_star < (-state_limit)) or (v_star > state_limit):
            anew = 1.0
            status = 5.0
        if (anew > 0.5) or (dt > dt_high) or (live < 0.5):  # nothing is known of the state
            v_star = 0.0
            r_star = 0.0
            v_star_slope = 0.0
            r_star_slope = 0.0
            error_offset = 0.0
            slope_offset = 0.0
            fresh = 0.0
        ratio_v_star = inv_U*scale_before  # same physical state in the new scale
        v_star = ratio_v_star*v_star
        v_star_slope = ratio_v_star*v_star_slope
        ratio_r_star = inv_U*scale_before  # same physical state in the new scale
        r_star = r_star*ratio_r_star
        r_star_slope = r_star_slope*ratio_r_star
        u = 0.5*last_input + 0.5*u_now  # mean of the sample's two ends
        u_change = u_now - last_input
        h = at_U*inv_L*(dt if dt < dt_high else 0.0)  # dimensionless time step
        inv0 = (1.0/rho)
        inv1 = (1.0/(pi1 - 1.0))
        c0 = (-r_star)
        c1 = pi1*r_star
        c2 = eta*(c0 + c1 + v_star)
        c3 = inv1*pi1
        c4 = u - c1 - v_star
        c5 = K*(inv_U*inv_U)
        c6 = c5*(c4 + c2*c3)
        c7 = c5*inv0
        c8 = c7*inv1
        c9 = c8*((-c2) - c4)
        c10 = 0.16666666666666666*h
        c11 = eta - 1.0
        f_v_star = c0 + c6  # rate [-]
        f_r_star = c9  # rate [-]
        J_00 = c10*c5*(c3*eta - 1.0)
        J_01 = c10*(c11*c5*pi1 - 1.0)
        J_10 = (-c10*c11*c8)
        J_11 = c10*c7*(inv1*pi1 - eta)
        f_v_star_K = c6
        f_r_star_K = c9
        f_v_star_u = c5
        f_r_star_u = (-c8)
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
        ramp = h*u_change
        ramp_0 = ramp*w0
        ramp_1 = ramp*w1
        slope1_v_star = J_00*f_v_star_u + J_01*f_r_star_u
        slope1_r_star = J_10*f_v_star_u + J_11*f_r_star_u
        rise_v_star = f_v_star_u*ramp_0 + ramp_1*slope1_v_star  # the input rises or falls in a straight line [-]
        rise_r_star = f_r_star_u*ramp_0 + ramp_1*slope1_r_star
        d_v_star = rise_v_star + G_00*f_v_star + G_01*f_r_star  # change over the step [-]
        d_r_star = rise_r_star + G_10*f_v_star + G_11*f_r_star  # change over the step [-]
        F_v_star_K = G_00*f_v_star_K + G_01*f_r_star_K
        F_r_star_K = G_10*f_v_star_K + G_11*f_r_star_K
        after_v_star = d_v_star + v_star
        after_r_star = d_r_star + r_star
        after_v_star_slope = F_v_star_K + M_00*v_star_slope + M_01*r_star_slope
        after_r_star_slope = F_r_star_K + M_10*v_star_slope + M_11*r_star_slope
        v_star = after_v_star
        v_star_slope = after_v_star_slope
        r_star = after_r_star
        r_star_slope = after_r_star_slope
        output_scale = at_U*inv_L
        inv_output_scale = L*inv_U
        follow = usable*(1.0 if (1.0) < (dt*offset_rate) else dt*offset_rate)
        slope = output_scale*r_star_slope
        error = y_now - output_scale*r_star
        error_offset = error_offset + follow*(error - error_offset)
        slope_offset = slope_offset + follow*(slope - slope_offset)
        psi = slope - slope_offset  # sensitivity without its slow part
        residual = error - error_offset  # error without its slow part
        innovation = (residual if usable > 0.5 else 0.0)
        predicted = error_offset + y_now - error  # the model and its offset
        drive = psi  # what the input alone does to the regression
        excitation = excitation + ((drive*drive) - excitation)*(1.0 if (1.0) < (dt*excitation_rate) else dt*excitation_rate)
        excited = (1.0 if excitation > excitation_least else 0.0)
        keep = 1.0 - (0.5 if (0.5) < (dt*forgetting_rate) else dt*forgetting_rate)
        if (excited > 0.5) and (fresh > settle_samples) and (live > 0.5):  # the input excites the unknown
            A = (psi*psi) + A*keep
            wanted = psi*residual/A
            move = ((-move_limit) if ((-move_limit)) > ((move_limit if (move_limit) < (wanted) else wanted)) else (move_limit if (move_limit) < (wanted) else wanted))
            K = K*(1.0 + move*(1.0 + move*(0.5 + 0.16666666666666666*move)))
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
                log_variance = (variance_limit if (variance_limit) < (spread*(1.0 + 5.0/blocks)/A) else spread*(1.0 + 5.0/blocks)/A)
                told = (psi*psi)/spread  # by this sample
                information = information + told
            status = 0.0
            if (last_U*last_U)*(y_now*y_now) > (validity_limit*validity_limit):
                status = 2.0
            if edge > 0.5:  # the population's edge
                status = 3.0
        if (excited > 0.5) and (fresh > settle_samples) and (live > 0.5):  # unseen, K may change
            aged = aged*keep
        else:
            aged = (variance_limit if (variance_limit) < (aged + dt*idle_drift) else aged + dt*idle_drift)
        damped = K*damping*inv_L*inv_U
        held = K*stiffness*(inv_L*inv_L) + pair_output*(K*K)*(inv_L*inv_L)*(inv_U*inv_U)  # y'' = -held y
        pull = inv_output_scale*usable*(1.0 if (1.0) < (dt*(observer_rate + 4.0*(0.0 if (0.0) > (observer_margin - held) else observer_margin - held)/damped)) else dt*(observer_rate + 4.0*(0.0 if (0.0) > (observer_margin - held) else observer_margin - held)/damped))
        r_star = r_star + pull*residual
        r_star_slope = r_star_slope - psi*pull
        scale_before = last_U
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
    state[:] = [K, v_star, r_star, v_star_slope, r_star_slope, damping, stiffness, pair_output, scale_before, A, error_offset, slope_offset, excitation, mean_square, block_score, block_weight, block_age, scatter_sum, scatter_weight, blocks, log_variance, aged, information, last_input, last_measured, last_U, fresh, started]
    return int(status), [estimate, variance, predicted, innovation, innovation_variance, information_gained, unknowns]
