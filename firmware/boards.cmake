# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# The boards: processor flags for the compiler and the emulator's name of the machine. A board NAME has a
# linker script boards/NAME.ld.
set(an385_processor -mcpu=cortex-m3 -mthumb)
set(an385_machine mps2-an385)
set(an386_processor -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16)
set(an386_machine mps2-an386)
set(an500_processor -mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16)
set(an500_machine mps2-an500)
set(an547_processor -mcpu=cortex-m55 -mthumb -mfloat-abi=hard)
set(an547_machine mps3-an547)
set(netduinoplus2_processor -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16)
set(netduinoplus2_machine netduinoplus2)
