/*
 * A 1 kHz control loop around an exported model. On a controller replace target_mm, command_motor and
 * wait_for_next_millisecond; on a PC it prints a few lines and ends. Its targets go past the model's range on purpose, to show what a refusal is. It never winds
 * backwards, and does not go to a twist that was not recorded around what the state tells (tsa_recorded):
 *     python -m pipeline.export processed/synthetic/spline/within-0.model --format c
 *     cc -I reports/synthetic/spline examples/control_loop.c -lm && ./a.out
 */
#include "tsa.h"

#include <stdio.h>

#define TICKS 3000 /* 1 ms each */

/* The least twist that the motor is sent to: a range reaches a little below 0, which would be wound backwards. */
static tsa_real least_turns(void)
{
    return TSA_MOTOR_TURNS_MIN > 0 ? TSA_MOTOR_TURNS_MIN : 0;
}

/* What the task wants, in mm: a ramp from where the motor begins to the range's end, past it, and back. */
static tsa_real target_mm(int tick, tsa_real low)
{
    const tsa_real span = TSA_DISPLACEMENT_MM_MAX - low;
    const tsa_real share = TSA_R(tick < TICKS / 2 ? tick : TICKS - tick) / TSA_R(TICKS / 2);
    return low + span * share * TSA_R(1.1);
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

/* Whether anything was recorded around a twist and the state: a header says so where its dataset was there. */
static int recorded(const tsa_state *state, tsa_real turns)
{
#ifdef TSA_HAS_RECORDED
    return tsa_recorded(state, turns) == TSA_OK;
#else
    (void)state;
    (void)turns;
    return 1;
#endif
}

/* What was not recorded, what was, and the mend. */
static void say_unrecorded(const tsa_state *state, tsa_real turns, int tick)
{
    const char *mend = "the state to one that was recorded";
#if defined(TSA_HAS_RECORDED) && defined(TSA_LOAD_N_MIN)
    if (tsa_stroke_recorded(state) != TSA_OK) {
        mend = "state.stroke to one that was recorded under this load, or state.load_n to one of this stroke";
        printf("%4d ms: stroke %d was not recorded under %.3g N", tick, state->stroke, (double)state->load_n);
    } else {
        mend = "state.stroke and state.load_n to a stroke and a load that were wound so far";
        printf("%4d ms: %.4g turns were not recorded under %.3g N in stroke %d", tick, (double)turns,
               (double)state->load_n, state->stroke);
    }
#else
    (void)state;
    printf("%4d ms: %.4g turns were not recorded in this state", tick, (double)turns);
#endif
#ifdef TSA_RECORDED
    printf(" (recorded: %s)", TSA_RECORDED);
#endif
    printf(": set %s. The motor stays where it is\n", mend);
}

static void command_motor(tsa_real turns)
{
    (void)turns;
}

static void wait_for_next_millisecond(void)
{
}

/* What a PC prints twice a second: the target, and the twist that the motor was sent to for it, or stays at. */
static void report(int tick, tsa_real wanted_mm, tsa_real turns, int moved)
{
    if (tick % 500 == 0 && moved) {
        printf("%4d ms: %.2f mm → %.3f turns\n", tick, (double)wanted_mm, (double)turns);
    } else if (tick % 500 == 0) {
        printf("%4d ms: %.2f mm: it stays at %.3f turns\n", tick, (double)wanted_mm, (double)turns);
    }
}

int main(void)
{
    /* Recorded. Set here a load, and a stroke that was recorded under it: state.load_n = ...; state.stroke = ...; */
    tsa_state state = tsa_start();
    tsa_real turns = least_turns(), low_mm = TSA_DISPLACEMENT_MM_MIN, last_mm;
    int refused = 0, past = 0, unrecorded = 0, tick;
    (void)tsa_forward(&state, turns, &low_mm); /* refused, it writes nothing, and each target is refused below */
    last_mm = low_mm;
    for (tick = 0; tick < TICKS; ++tick) {
        const tsa_real wanted_mm = target_mm(tick, low_mm);
        tsa_real answer = turns;
        int code, moved = 0;
        if (wanted_mm != last_mm) {
            state.direction = wanted_mm > last_mm ? 1 : -1; /* winding, or unwinding */
        }
        last_mm = wanted_mm;
        code = tsa_inverse(&state, wanted_mm, &answer);
        if (code <= TSA_OK && answer < least_turns()) {
            answer = least_turns();
        }
        past += code > TSA_OK && wanted_mm > TSA_DISPLACEMENT_MM_MAX;
        if (code > TSA_OK) {
            if (refused++ == 0) {
                printf("%4d ms: %.2f mm refused, %s: the motor stays where it is\n", tick, (double)wanted_mm, refusal(code));
            }
        } else if (!recorded(&state, answer)) {
            if (unrecorded++ == 0) {
                say_unrecorded(&state, answer, tick);
            }
        } else {
            turns = answer;
            moved = 1;
        }
        command_motor(turns); /* after a refusal `turns` is the last good one */
        report(tick, wanted_mm, turns, moved);
        wait_for_next_millisecond();
    }
    if (unrecorded) {
        printf("%d of %d targets ask for a twist that was not recorded with this state\n", unrecorded, TICKS);
    } else if (refused < TICKS) {
        printf("all %d answered targets ask for a twist that was recorded with this state\n", TICKS - refused);
    }
    printf("%d of %d targets refused, %d of them past the model's range, on purpose\n", refused, TICKS, past);
    return 0;
}
