// Lesson 01. Its card, and what it prints, checks and writes.
#pragma once

#include <vector>

#include "lessons/lesson.hpp"
#include "rod.hpp"

namespace cairn::one_row {

LessonInfo card();

void print_scene(Lesson& lesson, const Rod& rod);
void print_derivative(Lesson& lesson, const Rod& rod);
void print_motions(Lesson& lesson, const Rod& rod);
void print_kinds(Lesson& lesson, const std::vector<KindOfRows>& kinds);
void check_derivative(Lesson& lesson, const Rod& rod, const std::vector<KindOfRows>& kinds);
void check_force(Lesson& lesson, const Rod& rod);
CsvTable quotients_table(const Rod& rod);

}  // namespace cairn::one_row
