/* Runs stream_avr.c on simavr's ATmega328P: rows.bin in, words.bin out, as stream.c does on other boards.
 *
 * usage: simulate_avr FIRMWARE.elf SAMPLE_BYTES OUTPUT_BYTES STATE_BYTES
 * Cycles are those between the two writes of GPIOR1, stack is the lowest stack pointer between them. */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

enum { GPIOR0 = 0x3E, GPIOR1 = 0x4A, GPIOR2 = 0x4B, SPL = 0x5D, SPH = 0x5E };

static uint16_t stack_pointer(const avr_t *avr)
{
    return (uint16_t)(avr->data[SPL] | (avr->data[SPH] << 8));
}

static void run_one(avr_t *avr)
{
    int state = avr_run(avr);
    if ((state == cpu_Done) || (state == cpu_Crashed)) {
        fprintf(stderr, "the firmware crashed\n");
        exit(3);
    }
}

static void wait_for(avr_t *avr, int reg, int value)
{
    while (avr->data[reg] != value) {
        run_one(avr);
    }
}

int main(int argc, char **argv)
{
    elf_firmware_t firmware;
    avr_t *avr;
    FILE *rows = fopen("rows.bin", "rb");
    FILE *words = fopen("words.bin", "wb");
    int box, sample, output, state;
    uint32_t by_itself[2] = {0u, 0u}, most = 0u, deepest = 0u, asked = 0u;
    double sum = 0.0;
    long n = -1;
    if (argc != 5 || rows == NULL || words == NULL) {
        return 2;
    }
    sample = atoi(argv[2]);
    output = atoi(argv[3]);
    state = atoi(argv[4]);
    memset(&firmware, 0, sizeof firmware);
    if (elf_read_firmware(argv[1], &firmware) != 0) {
        return 2;
    }
    avr = avr_make_mcu_by_name("atmega328p");
    avr_init(avr);
    avr->log = LOG_NONE;
    avr_load_firmware(avr, &firmware);
    avr->frequency = 16000000;
    wait_for(avr, GPIOR0, 1);
    box = avr->data[GPIOR1] | (avr->data[GPIOR2] << 8);
    for (;;) {
        uint32_t head[4];
        avr_cycle_count_t begun, told = 0;
        uint16_t top, lowest;
        avr->data[GPIOR1] = 0;
        avr->data[GPIOR0] = 2;
        wait_for(avr, GPIOR1, 1);
        begun = avr->cycle;
        top = lowest = stack_pointer(avr);
        while (avr->data[GPIOR1] == 1) {
            run_one(avr);
            if (stack_pointer(avr) < lowest) {
                lowest = stack_pointer(avr);
            }
        }
        head[1] = (uint32_t)(avr->cycle - begun);
        head[2] = (uint32_t)(top - lowest);
        head[0] = (uint32_t)(avr->data[box + sample] | (avr->data[box + sample + 1] << 8));
        head[3] = 0u;
        while (avr->data[GPIOR0] != 1) {
            run_one(avr);
            if ((avr->data[GPIOR1] == 2) && (told == 0)) {
                told = avr->cycle;
            }
            if ((avr->data[GPIOR1] == 0) && (told != 0) && (head[3] == 0u)) {
                head[3] = (uint32_t)(avr->cycle - told);
            }
        }
        if (n < 0) {
            by_itself[0] = head[1];
            by_itself[1] = head[2];
        } else {
            sum += head[1] - by_itself[0];
            most = (head[1] - by_itself[0] > most) ? head[1] - by_itself[0] : most;
            asked = (head[3] > asked) ? head[3] : asked;
            deepest = (head[2] - by_itself[1] > deepest) ? head[2] - by_itself[1] : deepest;
        }
        ++n;
        fwrite(head, sizeof head, 1, words);
        fwrite(&avr->data[box + sample + 2], (size_t)output, 1, words);
        if (fread(&avr->data[box], (size_t)sample, 1, rows) != 1) {
            break;
        }
    }
    fwrite(&avr->data[box + sample + 2 + output], (size_t)state, 1, words);
    fclose(words);
    printf("cycles a sample, mean: %.1f\ncycles a sample, most: %u\n", sum / (double)n, (unsigned)most);
    if (asked > 0u) {
        printf("cycles of a report, most: %u\n", (unsigned)(asked - by_itself[0]));
    }
    printf("stack of a step, bytes: %u\n", (unsigned)deepest);
    return 0;
}
