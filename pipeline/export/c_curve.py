"""The rational-quadratic curve of one state in C (`networks.rational`), forwards, backwards and by prepared tables."""

CURVE = """\
static inline tsa_real tsa_spline(const tsa_tables *tables, tsa_real u)
{
    const tsa_real steps = (u - TSA_FIRST_U) * (1 / TSA_BIN_U);
    const int bin = steps < 0 ? 0 : steps < TSA_BINS ? (int)steps : TSA_BINS - 1;
    const tsa_real far = steps - (tsa_real)bin, share = far < 0 ? 0 : far > 1 ? 1 : far;
    const tsa_real rise = tables->rise[bin], steep = rise * (1 / TSA_BIN_U);
    const tsa_real left = tables->slope[bin], right = tables->slope[bin + 1], mixed = share * (1 - share);
    const tsa_real beyond = (far - share) * TSA_BIN_U * (far < 0 ? left : right);
    return tables->value[bin] + beyond
        + rise * (steep * share * share + left * mixed) / (steep + (left + right - 2 * steep) * mixed);
}

static inline tsa_real tsa_unspline(const tsa_tables *tables, tsa_real y)
{
    int bin = 0, k;
    tsa_real rise, steep, left, right, wanted, up, bend, a, b, c, root, divisor, share, beyond;
    for (k = 1; k < TSA_BINS; ++k) {
        bin += tables->value[k] <= y;
    }
    rise = tables->rise[bin];
    steep = rise * (1 / TSA_BIN_U);
    left = tables->slope[bin];
    right = tables->slope[bin + 1];
    wanted = y - tables->value[bin];
    up = wanted < 0 ? 0 : wanted > rise ? rise : wanted;
    beyond = (wanted - up) / (wanted < 0 ? left : right);
    bend = up * (left + right - 2 * steep);
    a = rise * (steep - left) + bend;
    b = rise * left - bend;
    c = -steep * up;
    root = b * b - 4 * a * c;
    divisor = -b - tsa_sqrt(root > 0 ? root : 0);
    share = divisor < 0 ? 2 * c / divisor : 0;
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    return TSA_FIRST_U + ((tsa_real)bin + share) * TSA_BIN_U + beyond;
}

"""

QUERIES = """\
static inline tsa_real tsa_tables_forward(const tsa_tables *tables, tsa_real motor_turns)
{
    const tsa_real base_mm = tsa_base_mm(&tables->at, tables->mm_per_turn, motor_turns);
    return tsa_spline(tables, base_mm / tables->zone_mm) * tables->zone_mm;
}

static inline tsa_real tsa_tables_inverse(const tsa_tables *tables, tsa_real displacement_mm)
{
    const tsa_real base_mm = tsa_unspline(tables, displacement_mm / tables->zone_mm) * tables->zone_mm;
    return tsa_base_turns(&tables->at, tables->mm_per_turn, base_mm);
}

static inline tsa_real tsa_raw_forward(const tsa_state *at, tsa_real motor_turns)
{
    tsa_tables tables;
    tsa_knots(at, &tables);
    return tsa_tables_forward(&tables, motor_turns);
}

static inline tsa_real tsa_raw_inverse(const tsa_state *at, tsa_real displacement_mm)
{
    tsa_tables tables;
    tsa_knots(at, &tables);
    return tsa_tables_inverse(&tables, displacement_mm);
}

"""

PREPARED = """\
static inline int tsa_prepare(const tsa_state *at, tsa_tables *tables)
{
    const int refused = tsa_check(at);
    if (refused == TSA_OK) {
        tsa_knots(at, tables);
    }
    return refused;
}

static inline int tsa_forward_prepared(const tsa_tables *tables, tsa_real motor_turns, tsa_real *displacement_mm)
{
    if (!(motor_turns >= TSA_MOTOR_TURNS_MIN && motor_turns <= TSA_MOTOR_TURNS_MAX)) {
        return TSA_BAD_MOTOR_TURNS;
    }
    *displacement_mm = tsa_tables_forward(tables, motor_turns);
    return TSA_OK;
}

static inline int tsa_inverse_prepared(const tsa_tables *tables, tsa_real displacement_mm, tsa_real *motor_turns)
{
    if (!(displacement_mm >= TSA_DISPLACEMENT_MM_MIN && displacement_mm <= TSA_DISPLACEMENT_MM_MAX)) {
        return TSA_BAD_DISPLACEMENT_MM;
    }
    return tsa_held(tsa_tables_inverse(tables, displacement_mm), motor_turns);
}

"""
