/* The firmware's protocol on this computer: time runs PACE times as fast, the sensors follow the motor at once. */
#include "board.h"

#include "bench.h"

static double began_s, pace;
static uint32_t taken, moving; /* samples since boot, and since the motor was first moved */
static int32_t target_steps;
static double steps, steps_a_sample;

void board_begin(void)
{
    line_open();
    pace = setting("PACE", 1);
    began_s = now_s();
}

void board_rest(void)
{
    usleep(500);
}

uint32_t board_nonce(void)
{
    return (uint32_t)getpid();
}

void board_put(uint8_t byte)
{
    line_put(byte);
}

uint8_t board_room(void)
{
    return setting("NO_ROOM_AT", -1) == moving ? 0 : 255;
}

bool board_get(uint8_t *byte)
{
    return line_get(byte);
}

bool board_sample(struct sample *sample)
{
    if ((now_s() - began_s) * pace * RATE_HZ < taken)
        return false;
    taken++;
    moving += moving || steps_a_sample > 0;
    double left = target_steps - steps;
    steps += fmax(-steps_a_sample, fmin(steps_a_sample, left));
    sample->t_us = (uint32_t)setting("FIRST_US", 0) + taken * (1000000 / RATE_HZ);
    sample->motor_counts = motor_at(board_steps());
    sample->displacement_counts = displacement_at(sample->motor_counts, 1.0 / RATE_HZ);
    sample->load_steps = LOAD_STEPS;
    sample->missed = setting("MISSED_AT", -1) == moving ? 3 : 0;
    return true;
}

bool board_skipped(void)
{
    return setting("SKIPPED_AT", -1) == moving;
}

void board_drive(int32_t target, uint16_t steps_per_s)
{
    target_steps = target;
    steps_a_sample = (double)steps_per_s / RATE_HZ;
}

int32_t board_steps(void)
{
    return (int32_t)steps;
}
