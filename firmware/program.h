/* A program of motion of docs/protocol.md: kept leg by leg, weighed as a whole. Knows no hardware. */
#ifndef PROGRAM_H
#define PROGRAM_H

#include <stdbool.h>
#include <stdint.h>

#include "wire.h"

#define LEG_PAYLOAD 14
#define PROGRAM_PAYLOAD 6
#define TAKEN_PAYLOAD 9

enum answer { ACCEPTED, BROKEN, TOO_MANY, TURNS, SPEED, ACCELERATED, LOAD, SECONDS, BUSY };

struct leg {
    uint32_t ms;
    int32_t milliturns;
};

void program_forget(void);
void program_leg(const struct command *command);

/* Weighs what came against what the host says of it, from where the motor stands; fills in what TAKEN says of it. */
enum answer program_weigh(const struct command *command, int32_t at_steps, uint16_t *count, uint32_t *crc, uint16_t *leg);

uint16_t program_legs(void); /* of a program that was accepted; 0 without one */
const struct leg *program_at(uint16_t number);

int32_t steps_of(int32_t milliturns);

/* The speed between even ramps, in 1/16 steps/s, with which a way takes so long; -1 where the ramps are too slow. */
int32_t cruise_of(int32_t steps, uint32_t ms);

#endif
