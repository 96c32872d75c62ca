#include "wire.h"

#include "board.h"

#define GROUP 254 /* bytes without a zero that one COBS code can announce */
#define COMMAND 7 /* kind u8, seq u32, crc u16: the host's frames have no payload */

static uint8_t group[GROUP];
static uint8_t grouped;
static bool was_full; /* the last group was: no zero stood behind it */
static uint16_t crc;

/* CRC-16/CCITT-FALSE, a byte at a time and without a table; start with 0xFFFF. */
static uint16_t crc_of(uint16_t sum, uint8_t byte)
{
    sum = (uint16_t)(sum >> 8 | sum << 8);
    sum ^= byte;
    sum ^= (uint8_t)sum >> 4;
    sum ^= (uint16_t)(sum << 12);
    sum ^= (uint16_t)((sum & 0xFF) << 5);
    return sum;
}

static void put_group(void)
{
    board_put((uint8_t)(grouped + 1));
    for (uint8_t at = 0; at < grouped; at++)
        board_put(group[at]);
    was_full = grouped == GROUP;
    grouped = 0;
}

static void stuff(uint8_t byte)
{
    if (byte == 0) {
        put_group();
        was_full = false;
        return;
    }
    group[grouped++] = byte;
    if (grouped == GROUP)
        put_group();
}

void frame_u8(uint8_t number)
{
    crc = crc_of(crc, number);
    stuff(number);
}

void frame_u16(uint16_t number)
{
    frame_u8((uint8_t)number);
    frame_u8((uint8_t)(number >> 8));
}

void frame_u32(uint32_t number)
{
    frame_u16((uint16_t)number);
    frame_u16((uint16_t)(number >> 16));
}

void frame_begin(enum kind kind, uint32_t seq)
{
    crc = 0xFFFF;
    grouped = 0;
    was_full = false;
    frame_u8((uint8_t)kind);
    frame_u32(seq);
}

void frame_end(void)
{
    uint16_t sum = crc;
    frame_u16(sum);
    if (grouped > 0 || !was_full)
        put_group();
    board_put(0);
}

/* Undo COBS in place: the code bytes that stood for zeros become zeros; false for what no stuffing makes. */
static bool unstuff(uint8_t *bytes, uint8_t count)
{
    uint16_t next = bytes[0];
    for (uint8_t at = 1; at < count; at++) {
        if (at == next) {
            next += bytes[at];
            bytes[at] = 0;
        }
    }
    return next == count;
}

bool frame_heard(uint8_t byte, struct command *command)
{
    static uint8_t heard[COMMAND + 1];
    static uint8_t count;

    if (byte != 0) {
        if (count < sizeof heard)
            heard[count] = byte;
        if (count < UINT8_MAX)
            count++; /* too many bytes are counted, not kept */
        return false;
    }
    uint8_t length = count;
    count = 0;
    if (length != sizeof heard || !unstuff(heard, length))
        return false;
    uint16_t sum = 0xFFFF;
    for (uint8_t at = 1; at <= COMMAND - 2; at++)
        sum = crc_of(sum, heard[at]);
    if (heard[COMMAND - 1] != (uint8_t)sum || heard[COMMAND] != (uint8_t)(sum >> 8))
        return false;
    command->kind = heard[1];
    command->seq = (uint32_t)heard[2] | (uint32_t)heard[3] << 8 | (uint32_t)heard[4] << 16 | (uint32_t)heard[5] << 24;
    return true;
}
