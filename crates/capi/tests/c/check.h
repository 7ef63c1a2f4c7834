/* Shared parts of the test programs: a check that ends the program on failure, and the test models. */
#ifndef CHECK_H
#define CHECK_H

#include <percuss.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(condition)                                                                          \
  do {                                                                                            \
    if (!(condition)) {                                                                           \
      fprintf(stderr, "%s:%d: %s\n  last message: %s\n", __FILE__, __LINE__, #condition,          \
              percuss_error_message());                                                           \
      exit(1);                                                                                    \
    }                                                                                             \
  } while (0)

#define OK(call) CHECK((call) == PERCUSS_OK)

/* The call fails with this status, and the message contains this text. */
#define FAILS(call, status, text)                                                                 \
  do {                                                                                            \
    CHECK((call) == (status));                                                                    \
    CHECK(strstr(percuss_error_message(), (text)) != NULL);                                       \
  } while (0)

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* A point mass of 2 kg on a massless rod, 0.5 m below its hinge: m = 2 (0.5/0.8)^2 = 0.78125 kg at a point 0.8 m
   below the hinge. */
static const char PENDULUM[] =
    "<robot name=\"pendulum\"><link name=\"ground\"/><link name=\"rod\"><inertial><origin xyz=\"0 0 -0.5\"/>"
    "<mass value=\"2\"/></inertial></link><joint name=\"hinge\" type=\"continuous\"><parent link=\"ground\"/>"
    "<child link=\"rod\"/><axis xyz=\"0 1 0\"/></joint></robot>";

/* A swing axle: the wheel centre 0.5 m from a hinge along x, the spring vertical at half of this distance. */
static const char SWING_AXLE[] =
    "template = \"swing-axle\"\nunit = \"m\"\naxes = \"iso\"\n[points]\nwheel_centre = [0, 0.7, 0.3]\n"
    "pivot_front = [0.1, 0.2, 0.3]\npivot_back = [-0.1, 0.2, 0.3]\nspring_seat = [0, 0.45, 0.3]\n"
    "spring_chassis_seat = [0, 0.45, 0.6]\n[spring]\nrate = \"20 N/mm\"\n[axle_tube]\nmass = 6\ncom = [0, 0.4, 0.3]\n"
    "inertia = [0.1, 0.02, 0.1]\n[spindle]\nmass = 4\ninertia = [0.02, 0.03, 0.02]\n[wheel]\nmass = 15\n"
    "inertia = [0.5, 0.9, 0.5]\nradius = 0.3\n";

/* A planar four-bar: crank 0.2 m, coupler 0.7 m, rocker 0.5 m, its pivots 0.6 m apart. */
static const char FOUR_BAR[] =
    "<robot name=\"four_bar\"><link name=\"ground\"/>"
    "<link name=\"crank\"><inertial><origin xyz=\"0.1 0 0\"/><mass value=\"1\"/>"
    "<inertia ixx=\"0.001\" iyy=\"0.004\" izz=\"0.004\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
    "<link name=\"coupler\"><inertial><origin xyz=\"0.35 0 0\"/><mass value=\"2\"/>"
    "<inertia ixx=\"0.001\" iyy=\"0.08\" izz=\"0.08\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
    "<link name=\"rocker\"><inertial><origin xyz=\"0.25 0 0\"/><mass value=\"1.5\"/>"
    "<inertia ixx=\"0.001\" iyy=\"0.03\" izz=\"0.03\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
    "<joint name=\"crank_hinge\" type=\"continuous\"><parent link=\"ground\"/><child link=\"crank\"/>"
    "<axis xyz=\"0 0 1\"/></joint>"
    "<joint name=\"coupler_hinge\" type=\"continuous\"><parent link=\"crank\"/><child link=\"coupler\"/>"
    "<origin xyz=\"0.2 0 0\" rpy=\"0 0 0.7\"/><axis xyz=\"0 0 1\"/></joint>"
    "<joint name=\"rocker_hinge\" type=\"continuous\"><parent link=\"ground\"/><child link=\"rocker\"/>"
    "<origin xyz=\"0.6 0 0\" rpy=\"0 0 1.4\"/><axis xyz=\"0 0 1\"/></joint>"
    "<loop name=\"pin\" type=\"revolute\"><predecessor link=\"coupler\"><origin xyz=\"0.7 0 0\"/></predecessor>"
    "<successor link=\"rocker\"><origin xyz=\"0.5 0 0\"/></successor><axis xyz=\"0 0 1\"/></loop></robot>";

static inline percuss_model *loaded(const char *text)
{
  percuss_model *model = NULL;
  OK(percuss_model_load_memory("text.urdf", text, strlen(text), &model));
  CHECK(model != NULL);
  return model;
}

static inline int near_to(double got, double expected, double relative)
{
  return fabs(got - expected) <= relative * fabs(expected);
}

#endif
