/*
 * A 1 kHz control loop around an exported model. On a controller replace the three functions below; on a PC it prints
 * a few lines and ends. Its targets go past the model's range on purpose, to show what a refusal is:
 *     python -m pipeline.export processed/synthetic/spline/within-0.model --format c
 *     cc -I reports/synthetic/spline examples/control_loop.c -lm && ./a.out
 */
#include "tsa.h"

#include <stdio.h>

#define TICKS 3000 /* 1 ms each */

/* What the task wants, in mm: a ramp up and down over the model's range, and past its end. */
static tsa_real target_mm(int tick)
{
    const tsa_real low = TSA_DISPLACEMENT_MM_MIN, span = TSA_DISPLACEMENT_MM_MAX - TSA_DISPLACEMENT_MM_MIN;
    const tsa_real share = TSA_R(tick < TICKS / 2 ? tick : TICKS - tick) / TSA_R(TICKS / 2);
    return low + span * share * TSA_R(1.1);
}

/* The middle of an input's range, which the header defines for every input that the model has. */
#define MIDDLE(name) ((TSA_##name##_MIN + TSA_##name##_MAX) / 2)

/* Every input that this model has: what the task knows or measures belongs here instead of the middles. */
static tsa_state first_state(void)
{
    tsa_state state = {0}; /* a material's number is 0, the first */
    state.stroke = TSA_STROKE_MIN;
    state.direction = TSA_DIRECTION_MAX;
#ifdef TSA_LOAD_N_MIN
    state.load_n = MIDDLE(LOAD_N);
#endif
#ifdef TSA_SEPARATOR_MM_MIN
    state.separator_mm = MIDDLE(SEPARATOR_MM);
#endif
#ifdef TSA_LENGTH_MM_MIN
    state.length_mm = MIDDLE(LENGTH_MM);
#endif
#ifdef TSA_RADIUS_MM_MIN
    state.radius_mm = MIDDLE(RADIUS_MM);
#endif
#ifdef TSA_TORSION_ZONE_MM_MIN
    state.torsion_zone_mm = MIDDLE(TORSION_ZONE_MM);
#endif
#ifdef TSA_STIFFNESS_N_PER_MM_MIN
    state.stiffness_n_per_mm = MIDDLE(STIFFNESS_N_PER_MM);
#endif
    return state;
}

/* A refusal's name in the header: it says which input is out of its range, or NaN. */
static const char *refusal(int code)
{
    switch (code) {
    case TSA_BAD_DISPLACEMENT_MM: return "TSA_BAD_DISPLACEMENT_MM";
    case TSA_BAD_STROKE: return "TSA_BAD_STROKE";
    case TSA_BAD_DIRECTION: return "TSA_BAD_DIRECTION";
    case TSA_BAD_LOAD_N: return "TSA_BAD_LOAD_N";
    case TSA_BAD_SEPARATOR_MM: return "TSA_BAD_SEPARATOR_MM";
    case TSA_BAD_LENGTH_MM: return "TSA_BAD_LENGTH_MM";
    case TSA_BAD_RADIUS_MM: return "TSA_BAD_RADIUS_MM";
    case TSA_BAD_TORSION_ZONE_MM: return "TSA_BAD_TORSION_ZONE_MM";
    case TSA_BAD_STIFFNESS_N_PER_MM: return "TSA_BAD_STIFFNESS_N_PER_MM";
    case TSA_BAD_MATERIAL: return "TSA_BAD_MATERIAL";
    default: return "TSA_BAD_MOTOR_TURNS";
    }
}

static void command_motor(tsa_real turns, int tick)
{
    if (tick % 500 == 0) {
        printf("%4d ms: %.3f turns\n", tick, (double)turns);
    }
}

static void wait_for_next_millisecond(void)
{
}

int main(void)
{
    tsa_state state = first_state();
    tsa_real turns = 0, last_mm = target_mm(0);
    int refused = 0, past = 0, tick;
    for (tick = 0; tick < TICKS; ++tick) {
        const tsa_real wanted_mm = target_mm(tick);
        int code;
        if (wanted_mm != last_mm) {
            state.direction = wanted_mm > last_mm ? 1 : -1; /* winding, or unwinding */
        }
        last_mm = wanted_mm;
        code = tsa_inverse(&state, wanted_mm, &turns);
        past += code > TSA_OK && wanted_mm > TSA_DISPLACEMENT_MM_MAX;
        if (code > TSA_OK && refused++ == 0) {
            printf("%4d ms: refused, %s: the motor stays where it is\n", tick, refusal(code));
        }
        command_motor(turns, tick); /* after a refusal `turns` is the last good one */
        wait_for_next_millisecond();
    }
    printf("%d of %d targets refused, %d of them past the model's range, on purpose\n", refused, TICKS, past);
    return 0;
}
