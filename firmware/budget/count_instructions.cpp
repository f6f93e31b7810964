// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// A plugin of the emulator that counts instructions between the functions `count_begin` and `count_end` of
// the emulated program. Each pair gives one line: the number. Counts are exact and the same in every run.
//
//   qemu-system-arm ... -plugin libcount_instructions.so -d plugin -D COUNTS.txt
//
// Debian's emulator comes without the header of its plugin interface; these are the parts in use.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>

extern "C" {
extern const int qemu_plugin_version;
const int qemu_plugin_version = 1;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
using PluginId = std::uint64_t;
void qemu_plugin_register_vcpu_tb_trans_cb(PluginId id,
                                           void (*translated)(PluginId id, qemu_plugin_tb* block));
std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb* block);
qemu_plugin_insn* qemu_plugin_tb_get_insn(const qemu_plugin_tb* block, std::size_t index);
const char* qemu_plugin_insn_symbol(const qemu_plugin_insn* instruction);
void qemu_plugin_register_vcpu_insn_exec_inline(qemu_plugin_insn* instruction, int operation, void* number,
                                                std::uint64_t added);
void qemu_plugin_register_vcpu_insn_exec_cb(qemu_plugin_insn* instruction, void (*executed)(unsigned, void*),
                                            int flags, void* user);
void qemu_plugin_outs(const char* text);
int qemu_plugin_install(PluginId id, const void* info, int argc, char** argv);
}

namespace {

constexpr int add = 0;
constexpr int no_registers = 0;

std::uint64_t executed = 0;
std::uint64_t at_begin = 0;

void begin(unsigned /*processor*/, void* /*user*/) {
  at_begin = executed;
}

void end(unsigned /*processor*/, void* /*user*/) {
  char line[32];
  std::snprintf(line, sizeof line, "%llu\n", static_cast<unsigned long long>(executed - at_begin));
  qemu_plugin_outs(line);
}

// A symbol names every instruction of its function; the function is entered at the first one alone, which
// here is the first of its block and the only one: both functions are a single return.
bool is(const char* symbol, const char* name) {
  return symbol != nullptr && std::strcmp(symbol, name) == 0;
}

void translated(PluginId /*id*/, qemu_plugin_tb* block) {
  for (std::size_t i = 0; i < qemu_plugin_tb_n_insns(block); ++i) {
    qemu_plugin_insn* instruction = qemu_plugin_tb_get_insn(block, i);
    const char* symbol = qemu_plugin_insn_symbol(instruction);
    if (is(symbol, "count_begin"))
      qemu_plugin_register_vcpu_insn_exec_cb(instruction, begin, no_registers, nullptr);
    if (is(symbol, "count_end"))
      qemu_plugin_register_vcpu_insn_exec_cb(instruction, end, no_registers, nullptr);
    qemu_plugin_register_vcpu_insn_exec_inline(instruction, add, &executed, 1);
  }
}

}  // namespace

int qemu_plugin_install(PluginId id, const void* /*info*/, int /*argc*/, char** /*argv*/) {
  qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
  return 0;
}
