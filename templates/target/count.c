/* count.c - a plugin for QEMU: instructions, and cycles of a Cortex-M, between two functions.
   SPDX-License-Identifier: GPL-3.0-or-later

     qemu-system-arm ... -plugin ./count.so,begin=0xADDRESS,end=0xADDRESS -d plugin -D FILE

   FILE gets one line a time that `end` was reached: how many instructions were executed since
   `begin` was entered, its own first included, and the cycles that these take on a Cortex-M without
   wait states by Arm's tables (DDI 0432C, table 3-1; DDI 0337I, table 3-1; DDI 0439B, tables 3-1
   and 7-1): one each, and besides for each number loaded or stored 1, a branch that is taken 2, a
   division 5 (the middle of what the tables allow), VDIV and VSQRT 13, VFMA 2; a long product takes
   `product=` more, 3 on a Cortex-M3. On other processors the second number says nothing. What
   QEMU's plugin interface, version 1, looks like is declared here, because Debian ships no header
   for it. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum qemu_plugin_cb_flags { QEMU_PLUGIN_CB_NO_REGS };
typedef void (*translated)(qemu_plugin_id_t id, struct qemu_plugin_tb *tb);
typedef void (*executed)(unsigned int cpu, void *data);
extern void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, translated call);
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *tb);
extern struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *tb, size_t i);
extern uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *insn);
extern const void *qemu_plugin_insn_data(const struct qemu_plugin_insn *insn);
extern size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *insn);
extern void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *insn, executed call,
                                                   enum qemu_plugin_cb_flags flags, void *data);
extern void qemu_plugin_outs(const char *text);

#define SHOWN __attribute__((visibility("default")))
SHOWN int qemu_plugin_version = 1;
SHOWN int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int argc, char **argv);

static uint64_t begin, end, count, cycles, next, product;

static uint64_t bits(uint32_t x) {
  uint64_t n = 0;
  for (; x; x &= x - 1)
    n++;
  return n;
}

/* What a Thumb instruction of two or four bytes takes beyond one cycle, a branch not taken. */
static uint64_t more(const unsigned char *data, size_t size) {
  const uint32_t h = (uint32_t)data[0] | (uint32_t)data[1] << 8;
  const uint32_t k = size == 4 ? (uint32_t)data[2] | (uint32_t)data[3] << 8 : 0;

  if (size == 2) {
    if (h >= 0x4800 && h <= 0x9FFF) /* LDR, STR of all kinds */
      return 1;
    if ((h & 0xF600) == 0xB400) /* PUSH, POP */
      return bits(h & 0x1FF);
    return (h & 0xF000) == 0xC000 ? bits(h & 0xFF) : 0; /* STM, LDM */
  }
  if ((h & 0xFE40) == 0xE800) /* STM, LDM */
    return bits(k);
  if ((h & 0xFE40) == 0xE840) /* STRD, LDRD */
    return 2;
  if ((h & 0xFE00) == 0xF800) /* LDR, STR */
    return 1;
  if ((h & 0xFFD0) == 0xFB90) /* SDIV, UDIV */
    return 5;
  if ((h & 0xFF80) == 0xFB80) /* SMULL, UMULL, SMLAL, UMLAL */
    return product;
  if ((h & 0xFF00) == 0xED00 && (k & 0xE00) == 0xA00) /* VLDR, VSTR, or several with a decrement */
    return h & 0x20 ? k & 0xFF : 1;
  if ((h & 0xFF00) == 0xEC00 && (h & 0xE0) != 0x40 && (k & 0xE00) == 0xA00) /* VLDM, VSTM, VPOP */
    return k & 0xFF;
  if ((h & 0xFFB0) == 0xEE80 && (k & 0xF50) == 0xA00) /* VDIV */
    return 13;
  if ((h & 0xFFBF) == 0xEEB1 && (k & 0xFD0) == 0xAC0) /* VSQRT */
    return 13;
  return (h & 0xFFA0) == 0xEEA0 && (k & 0xE00) == 0xA00 ? 2 : 0; /* VFMA, VFMS */
}

/* data: the address, and above it in two bytes the instruction's length and what it takes */
static void step(unsigned int cpu, void *data) {
  const uint64_t word = (uint64_t)(uintptr_t)data, at = word & 0xFFFFFFFFU;
  char text[48];
  (void)cpu;
  if (at == begin)
    count = cycles = 0;
  if (at == end) {
    snprintf(text, sizeof text, "%" PRIu64 " %" PRIu64 "\n", count, cycles);
    qemu_plugin_outs(text);
  }
  count++;
  cycles += 1 + (word >> 40) + (at == next ? 0 : 2);
  next = at + (word >> 32 & 0xFF);
}

static void block(qemu_plugin_id_t id, struct qemu_plugin_tb *tb) {
  (void)id;
  for (size_t i = 0; i < qemu_plugin_tb_n_insns(tb); i++) {
    struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(tb, i);
    const size_t size = qemu_plugin_insn_size(insn);
    const uint64_t word = (qemu_plugin_insn_vaddr(insn) & 0xFFFFFFFFU) | (uint64_t)size << 32 |
                          more(qemu_plugin_insn_data(insn), size) << 40;
    qemu_plugin_register_vcpu_insn_exec_cb(insn, step, QEMU_PLUGIN_CB_NO_REGS,
                                           (void *)(uintptr_t)word);
  }
}

int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int argc, char **argv) {
  (void)info;
  for (int i = 0; i < argc; i++) {
    if (strncmp(argv[i], "begin=", 6) == 0)
      begin = strtoull(argv[i] + 6, NULL, 0);
    else if (strncmp(argv[i], "end=", 4) == 0)
      end = strtoull(argv[i] + 4, NULL, 0);
    else if (strncmp(argv[i], "product=", 8) == 0)
      product = strtoull(argv[i] + 8, NULL, 0);
    else
      return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, block);
  return 0;
}
