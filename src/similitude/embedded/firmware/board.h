/* Between the stream of samples and the board it runs on. */

#ifndef BOARD_H
#define BOARD_H

unsigned long ticks(void);                      /* a counter of instructions, modulo 2^24 */
unsigned long instructions(unsigned long ticks); /* that so many ticks are */
long call_host(long operation, void *argument); /* semihosting */
void leave(int code);
void stream(void);

#endif
