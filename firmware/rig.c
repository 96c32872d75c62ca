/* A rig that speaks docs/protocol.md: obeys the host, numbers what it sends, and says END until it is acknowledged. */
#include "board.h"
#include "config.h"
#include "motion.h"
#include "program.h"
#include "wire.h"

#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)
#define CHANNEL(name, unit, type, scale, offset)                                                                       \
    "{\"name\":\"" name "\",\"unit\":\"" unit "\",\"type\":\"" type "\",\"scale\":" scale ",\"offset\":" offset "}"

#define SAMPLE_PAYLOAD 14 /* t_us u32 and the channels below */
#define EVENT_PAYLOAD 9

enum event { STROKE_START = 1, STROKE_END = 2, FAULT = 3 };
enum reason { COMPLETE = 0, STOPPED = 1, FAULTY = 2, SILENT = 3 };
enum fault { MOTOR_STALLED = 1, ENCODER_SKIPPED = 2 }; /* our own numbers */

static const char HELLO_BEGIN[] PROGMEM =
    "{\"protocol\":2,\"device\":\"" DEVICE "\",\"firmware\":\"2.0\",\"nonce\":\"";
static const char HELLO_REST[] PROGMEM =
    "\",\"rate_hz\":" TEXT(RATE_HZ) ",\"strokes\":" TEXT(STROKES) ",\"channels\":["
    CHANNEL("motor_turns", "turns", "i32", MOTOR_SCALE, "0") ","
    CHANNEL("displacement_mm", "mm", "i32", DISPLACEMENT_SCALE, "0") ","
    CHANNEL("load_n", "N", "u16", LOAD_SCALE, LOAD_OFFSET) "],\"program\":{\"legs\":" TEXT(MOST_LEGS) ",\"turns\":[0,";
static const char HELLO_SPEED[] PROGMEM = "],\"turns_per_s\":";
static const char HELLO_RAMP[] PROGMEM = ",\"turns_per_s2\":";
static const char HELLO_SECONDS[] PROGMEM = ",\"seconds\":";
static const char HELLO_SILENCE[] PROGMEM = ",\"silence_s\":";
static const char HELLO_AT[] PROGMEM = ",\"at_turns\":";
static const char HELLO_END[] PROGMEM = "}}";

static enum { IDLE, RECORDING, ENDING } state;
static uint32_t next_seq, samples, nonce;
static uint8_t end_reason;
static uint16_t end_ticks; /* samples' time since END was first said */
static bool following; /* a program */
static uint32_t silence; /* samples' time since the host was heard */

static void say_text(const char *text)
{
    char one;
    while ((one = (char)pgm_read_byte(text++)) != 0)
        frame_u8((uint8_t)one);
}

/* A number of thousandths, as JSON has it. */
static void say_milli(int32_t number)
{
    uint32_t size = number < 0 ? -(uint32_t)number : (uint32_t)number;
    bool begun = false;
    if (number < 0)
        frame_u8('-');
    for (uint32_t place = 1000000000UL; place > 0; place /= 10) {
        uint8_t digit = (uint8_t)(size / place % 10);
        begun = begun || digit != 0 || place <= 1000;
        if (begun)
            frame_u8((uint8_t)('0' + digit));
        if (place == 1000)
            frame_u8('.');
    }
}

static int32_t milliturns(int32_t steps)
{
    return (int32_t)((int64_t)steps * 1000 / STEPS_PER_TURN);
}

static void say_hello(void)
{
    frame_begin(HELLO, 0);
    say_text(HELLO_BEGIN);
    for (int8_t shift = 28; shift >= 0; shift -= 4)
        frame_u8((uint8_t) "0123456789abcdef"[nonce >> shift & 15]);
    say_text(HELLO_REST);
    say_milli(TOP_TURNS * 1000);
    say_text(HELLO_SPEED);
    say_milli(milliturns(STEPS_PER_S));
    say_text(HELLO_RAMP);
    say_milli(milliturns(STEPS_PER_S2));
    say_text(HELLO_SECONDS);
    say_milli(LONGEST_S * 1000);
    say_text(HELLO_SILENCE);
    say_milli(SILENCE_MS);
    say_text(HELLO_AT);
    say_milli(milliturns(board_steps()));
    say_text(HELLO_END);
    frame_end();
}

static void say_end(void)
{
    frame_begin(END, next_seq);
    frame_u32(samples);
    frame_u8(end_reason);
    frame_end();
}

/* A frame takes its number in any case; without room for it nothing is sent, and the host sees the gap. */
static void say_event(uint32_t t_us, enum event code, int32_t value)
{
    uint32_t seq = next_seq++;
    if (board_room() < FRAME_BYTES(EVENT_PAYLOAD))
        return;
    frame_begin(EVENT, seq);
    frame_u32(t_us);
    frame_u8((uint8_t)code);
    frame_u32((uint32_t)value);
    frame_end();
}

static void say_sample(const struct sample *sample)
{
    uint32_t seq = next_seq++;
    samples++;
    if (board_room() < FRAME_BYTES(SAMPLE_PAYLOAD))
        return;
    frame_begin(SAMPLE, seq);
    frame_u32(sample->t_us);
    frame_u32((uint32_t)sample->motor_counts);
    frame_u32((uint32_t)sample->displacement_counts);
    frame_u16(sample->load_steps);
    frame_end();
}

static void end(enum reason reason)
{
    motion_halt();
    state = ENDING;
    end_reason = reason;
    end_ticks = 0;
    say_end();
}

static void say_taken(const struct command *command)
{
    uint16_t count = 0, leg = 0;
    uint32_t sum = 0;
    enum answer answer = BUSY;
    if (state == IDLE)
        answer = program_weigh(command, board_steps(), &count, &sum, &leg);
    frame_begin(TAKEN, 0);
    frame_u16(count);
    frame_u32(sum);
    frame_u8((uint8_t)answer);
    frame_u16(leg);
    frame_end();
}

static void obey(const struct command *command)
{
    struct sample stale;
    switch (command->kind) {
    case GREET:
        motion_halt();
        state = IDLE;
        program_forget();
        say_hello();
        break;
    case START:
        if (state != IDLE)
            break;
        while (board_sample(&stale))
            ;
        board_skipped(); /* what was skipped before is not of this recording */
        next_seq = 1;
        samples = 0;
        state = RECORDING;
        silence = 0;
        following = program_legs() > 0;
        if (following)
            motion_follow();
        else
            motion_begin();
        break;
    case LEG:
        if (state == IDLE && command->length == LEG_PAYLOAD)
            program_leg(command);
        break;
    case PROGRAM:
        if (command->length == PROGRAM_PAYLOAD)
            say_taken(command);
        break;
    case STOP:
        if (state == RECORDING)
            end(STOPPED);
        break;
    case ACK:
        if (state == ENDING && command->seq == next_seq)
            state = IDLE;
        break;
    }
}

static void record(const struct sample *sample)
{
    if (samples > 0) { /* else it was missed before START */
        next_seq += sample->missed;
        samples += sample->missed;
    }
    enum news news = motion_tick(sample->motor_counts);
    bool skipped = board_skipped();
    if (news == STALLED || skipped) {
        say_event(sample->t_us, FAULT, skipped ? ENCODER_SKIPPED : MOTOR_STALLED);
        end(FAULTY);
        return;
    }
    if (news == STROKE_STARTS || news == STROKE_ENDS)
        say_event(sample->t_us, news == STROKE_STARTS ? STROKE_START : STROKE_END, motion_stroke());
    say_sample(sample);
    if (news == FINISHED)
        end(COMPLETE);
    else if (following && ++silence >= TICKS(SILENCE_MS))
        end(SILENT);
}

/* What waits for END's acknowledgement goes by the samples' pace: again every 0.2 s, for 10 s. */
static void wait(void)
{
    end_ticks++;
    if (end_ticks >= RATE_HZ * 10L)
        state = IDLE;
    else if (end_ticks % (RATE_HZ / 5) == 0)
        say_end();
}

int main(void)
{
    board_begin();
    program_forget();
    nonce = board_nonce();
    board_put(0); /* ends the frame that a reset has cut off */
    say_hello(); /* tells a host that was recording of the reset */
    for (;;) {
        uint8_t byte;
        struct command command;
        struct sample sample;
        while (board_get(&byte))
            if (frame_heard(byte, &command)) {
                silence = 0;
                obey(&command);
            }
        while (board_sample(&sample)) {
            if (state == RECORDING)
                record(&sample);
            else if (state == ENDING)
                wait();
        }
        board_rest();
    }
}
