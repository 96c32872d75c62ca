/*
 * A 1 kHz control loop around an exported model. On a controller replace the three functions below; on a PC it prints
 * a few lines and ends:
 *     python -m pipeline.export processed/synthetic/spline/within-0.model --format c
 *     cc -I . examples/control_loop.c -lm && ./a.out
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
    tsa_state state = {0}; /* set further fields here, where the header has them: load_n, material... */
    tsa_real turns = 0, last_mm = target_mm(0);
    int refused = 0, tick;
    state.stroke = TSA_STROKE_MIN;
    for (tick = 0; tick < TICKS; ++tick) {
        const tsa_real wanted_mm = target_mm(tick);
        int code;
        if (wanted_mm != last_mm) {
            state.direction = wanted_mm > last_mm ? 1 : -1; /* winding, or unwinding */
        } else if (tick == 0) {
            state.direction = 1;
        }
        last_mm = wanted_mm;
        code = tsa_inverse(&state, wanted_mm, &turns);
        if (code > TSA_OK && refused++ == 0) {
            printf("%4d ms: refused, code %d: the motor stays where it is\n", tick, code);
        }
        command_motor(turns, tick); /* after a refusal `turns` is the last good one */
        wait_for_next_millisecond();
    }
    printf("%d of %d targets refused\n", refused, TICKS);
    return 0;
}
