/* count.c - a plugin for QEMU: instructions between two functions.
   SPDX-License-Identifier: GPL-3.0-or-later

     qemu-system-arm ... -plugin ./count.so,begin=0xADDRESS,end=0xADDRESS -d plugin -D FILE

   FILE gets one line a time that `end` was reached: how many instructions were executed since
   `begin` was entered, its own first included. What QEMU's plugin interface, version 1, looks like
   is declared here, because Debian ships no header for it. */
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
extern void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *insn, executed call,
                                                   enum qemu_plugin_cb_flags flags, void *data);
extern void qemu_plugin_outs(const char *text);

#define SHOWN __attribute__((visibility("default")))
SHOWN int qemu_plugin_version = 1;
SHOWN int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int argc, char **argv);

static uint64_t begin, end, count;

static void step(unsigned int cpu, void *data) {
  const uint64_t at = (uint64_t)(uintptr_t)data;
  char text[32];
  (void)cpu;
  if (at == begin)
    count = 0;
  if (at == end) {
    snprintf(text, sizeof text, "%" PRIu64 "\n", count);
    qemu_plugin_outs(text);
  }
  count++;
}

static void block(qemu_plugin_id_t id, struct qemu_plugin_tb *tb) {
  (void)id;
  for (size_t i = 0; i < qemu_plugin_tb_n_insns(tb); i++) {
    struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(tb, i);
    qemu_plugin_register_vcpu_insn_exec_cb(insn, step, QEMU_PLUGIN_CB_NO_REGS,
                                           (void *)(uintptr_t)qemu_plugin_insn_vaddr(insn));
  }
}

int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int argc, char **argv) {
  (void)info;
  for (int i = 0; i < argc; i++) {
    if (strncmp(argv[i], "begin=", 6) == 0)
      begin = strtoull(argv[i] + 6, NULL, 0);
    else if (strncmp(argv[i], "end=", 4) == 0)
      end = strtoull(argv[i] + 4, NULL, 0);
    else
      return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, block);
  return 0;
}
