#include "wire.h"

#include "board.h"

#define GROUP 254 /* bytes without a zero that one COBS code can announce */
#define COMMAND 9 /* kind u8, seq u32, crc u32, of a frame of the host without a payload */

static uint8_t group[GROUP];
static uint8_t grouped;
static bool was_full; /* the last group was: no zero stood behind it */
static uint32_t crc;

/* CRC-32 as in zip, half a byte at a time: its table has 64 bytes instead of 1024. Start with 0xFFFFFFFF, invert. */
static const uint32_t HALVES[16] PROGMEM = {
    0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC, 0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
    0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C, 0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};

uint32_t crc_of(uint32_t sum, uint8_t byte)
{
    sum = sum >> 4 ^ pgm_read_dword(&HALVES[(uint8_t)(sum ^ byte) & 15]);
    return sum >> 4 ^ pgm_read_dword(&HALVES[(uint8_t)(sum ^ byte >> 4) & 15]);
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
    crc = 0xFFFFFFFF;
    grouped = 0;
    was_full = false;
    frame_u8((uint8_t)kind);
    frame_u32(seq);
}

void frame_end(void)
{
    frame_u32(~crc);
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

uint32_t u32_at(const uint8_t *bytes)
{
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

bool frame_heard(uint8_t byte, struct command *command)
{
    static uint8_t heard[COMMAND + MOST_PAYLOAD + 1];
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
    if (length < COMMAND + 1 || length > sizeof heard || !unstuff(heard, length))
        return false;
    uint32_t sum = 0xFFFFFFFF;
    for (uint8_t at = 1; at < length - 4; at++)
        sum = crc_of(sum, heard[at]);
    if (u32_at(&heard[length - 4]) != (uint32_t)~sum)
        return false;
    command->kind = heard[1];
    command->seq = u32_at(&heard[2]);
    command->length = length - (COMMAND + 1);
    for (uint8_t at = 0; at < command->length; at++)
        command->payload[at] = heard[6 + at];
    return true;
}
