#include "program.h"

#include <stdlib.h>

#include "config.h"
#include "motion.h"

#define AS_IT_HANGS INT32_MIN

static struct leg legs[MOST_LEGS];
static uint16_t came; /* legs, in order, counted beyond what is kept */
static uint16_t load_asked; /* the first leg that asks for a load, from 1 */
static uint32_t sum; /* CRC-32 over their payloads, not yet inverted */
static bool ordered, accepted;

void program_forget(void)
{
    came = load_asked = 0;
    sum = 0xFFFFFFFF;
    ordered = true;
    accepted = false;
}

void program_leg(const struct command *command)
{
    uint16_t number = (uint16_t)(command->payload[0] | command->payload[1] << 8);
    if (number == 0)
        program_forget(); /* the host says it all again */
    accepted = false;
    if (number != came) {
        ordered = false;
        return;
    }
    if (number < MOST_LEGS) {
        legs[number].ms = u32_at(&command->payload[2]);
        legs[number].milliturns = (int32_t)u32_at(&command->payload[6]);
    }
    came++;
    if (load_asked == 0 && (int32_t)u32_at(&command->payload[10]) != AS_IT_HANGS)
        load_asked = came;
    for (uint8_t at = 0; at < LEG_PAYLOAD; at++)
        sum = crc_of(sum, command->payload[at]);
}

int32_t steps_of(int32_t milliturns)
{
    return (int32_t)((int64_t)milliturns * STEPS_PER_TURN / 1000);
}

static int64_t root_of(int64_t square)
{
    int64_t root = 0;
    for (int64_t bit = (int64_t)1 << 30; bit > 0; bit >>= 1)
        if ((root + bit) * (root + bit) <= square)
            root += bit;
    return root;
}

int32_t cruise_of(int32_t steps, uint32_t ms)
{
    int64_t fastest = (int64_t)STEPS_PER_S2 * ms * 16 / 1000;
    if (fastest > INT32_MAX)
        fastest = INT32_MAX; /* of a hold of a day */
    int64_t room = fastest * fastest - (int64_t)4 * 256 * STEPS_PER_S2 * labs(steps);
    return room < 0 ? -1 : (int32_t)((fastest - root_of(room)) / 2);
}

/* The first leg that is beyond a limit, and why; the load of a leg is asked about before its speed, as the host does. */
static enum answer beyond(int32_t at_steps, uint16_t *leg)
{
    uint32_t whole_ms = 0;
    for (uint16_t number = 0; number < came; number++) {
        int32_t to = legs[number].milliturns;
        *leg = number + 1;
        if (to < 0 || to > TOP_TURNS * 1000)
            return TURNS;
        if (load_asked == *leg)
            return LOAD;
        if (legs[number].ms > LONGEST_S * 1000 - whole_ms) {
            *leg = 0;
            return SECONDS;
        }
        whole_ms += legs[number].ms;
        int32_t speed = cruise_of(steps_of(to) - at_steps, legs[number].ms);
        if (speed < 0)
            return ACCELERATED;
        if (speed > STEPS_PER_S * 16)
            return SPEED;
        at_steps = steps_of(to);
    }
    *leg = 0;
    return ACCEPTED;
}

enum answer program_weigh(const struct command *command, int32_t at_steps, uint16_t *count, uint32_t *crc, uint16_t *leg)
{
    *count = came;
    *crc = ~sum;
    *leg = 0;
    uint16_t told = (uint16_t)(command->payload[0] | command->payload[1] << 8);
    if (!ordered || told != came || u32_at(&command->payload[2]) != *crc)
        return BROKEN;
    if (came == 0 || came > MOST_LEGS)
        return TOO_MANY;
    enum answer answer = beyond(at_steps, leg);
    if (answer != ACCEPTED)
        program_forget();
    accepted = answer == ACCEPTED;
    return answer;
}

uint16_t program_legs(void)
{
    return accepted ? came : 0;
}

const struct leg *program_at(uint16_t number)
{
    return &legs[number];
}
