/*
 * Time of one query of an exported header (-include it), in ns. Each query waits for the last one's answer, as in a
 * control loop, and each has a stroke and a direction of its own. Prints "name nanoseconds" lines, medians of rounds.
 */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define QUERIES 32

static tsa_state states[QUERIES];
static tsa_real turns[QUERIES], mm[QUERIES];
static double rounds_ns[ROUNDS];
static volatile tsa_real nothing = 0;

static double now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e9 + (double)now.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    const double difference = *(const double *)a - *(const double *)b;
    return (difference > 0) - (difference < 0);
}

static void say(const char *name)
{
    qsort(rounds_ns, ROUNDS, sizeof *rounds_ns, by_size);
    printf("%s %.2f\n", name, rounds_ns[ROUNDS / 2]);
}

static tsa_real between(tsa_real low, tsa_real high)
{
    return low + (high - low) * (tsa_real)rand() / (tsa_real)RAND_MAX;
}

#define TIMED(name, prepare, query)                                         \
    for (round = 0; round < ROUNDS; ++round) {                              \
        const double began_ns = now_ns();                                   \
        tsa_real last = 0;                                                  \
        for (i = 0; i < QUERIES; ++i) {                                     \
            prepare;                                                        \
            if ((query) > TSA_OK) {                                         \
                return 1;                                                   \
            }                                                               \
        }                                                                   \
        rounds_ns[round] = (now_ns() - began_ns) / QUERIES;                 \
    }                                                                       \
    say(name);

int main(void)
{
    const tsa_real zero = nothing;
    int i, round;
    for (i = 0; i < QUERIES; ++i) {
        states[i].stroke = TSA_STROKE_MIN + rand() % (TSA_STROKE_MAX - TSA_STROKE_MIN + 1);
        states[i].direction = rand() % 2 ? 1 : -1;
        FIELDS
        turns[i] = between(TSA_MOTOR_TURNS_MIN, TSA_MOTOR_TURNS_MAX);
        if (tsa_forward(&states[i], turns[i], &mm[i]) != TSA_OK) {
            return 1;
        }
        mm[i] = mm[i] < TSA_DISPLACEMENT_MM_MIN ? TSA_DISPLACEMENT_MM_MIN : mm[i];
        mm[i] = mm[i] > TSA_DISPLACEMENT_MM_MAX ? TSA_DISPLACEMENT_MM_MAX : mm[i];
    }
#define STATE                  \
    tsa_state at = states[i];  \
    at.stroke += (int)(zero * last)
    TIMED("forward", STATE, tsa_forward(&at, turns[i] + zero * last, &last))
    TIMED("inverse", STATE, tsa_inverse(&at, mm[i] + zero * last, &last))
#ifdef TSA_BINS
    {
        static tsa_tables tables[QUERIES];
        for (i = 0; i < QUERIES; ++i) {
            tsa_prepare(&states[i], &tables[i]);
        }
        TIMED("forward_prepared", (void)0, tsa_forward_prepared(&tables[i], turns[i] + zero * last, &last))
        TIMED("inverse_prepared", (void)0, tsa_inverse_prepared(&tables[i], mm[i] + zero * last, &last))
    }
#endif
    return 0;
}
