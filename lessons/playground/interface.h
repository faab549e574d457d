/* The playground in plain C: what a page, or any other language, calls. One playground a process, used from one thread.
 *
 * Functions that can refuse return 1 where they did what was asked and 0 where nothing has changed: then cairn_refusal()
 * says why, in the words that the command line uses. Those that only tell something give "", zeros or a count of 0 where
 * they cannot, and then cairn_refusal() says why, too. Whatever they are given, nothing is ever thrown out of them, and
 * numbers that are not finite, unknown names and null are refused. Texts are UTF-8, ended by a zero; those that are returned stay as
 * they are until the next call. Lengths are metres, masses kilograms, times seconds, angles radians, places on the picture
 * pixels from its top left corner. */
#ifndef CAIRN_PLAYGROUND_INTERFACE_H
#define CAIRN_PLAYGROUND_INTERFACE_H

#ifdef __cplusplus
extern "C" {
#endif

/** Why the last call refused; "" where it did not. */
const char* cairn_refusal(void);

/** How long a step may take, and a look at the solve that comes next [s]: 0.5 at first; 0 for as long as it takes. What
 *  takes longer is refused: a step, a setting or a scene. */
int cairn_patience(double seconds);
/** How many bytes the text of a scene may have. */
int cairn_most_text(void);

/** Begins anew with the text of a scene file, under the settings that it recommends. `file` is the name that messages
 *  give it: "scene:3:1: ...". */
int cairn_open(const char* text, const char* file);
/** The scene as text: as it was opened, with what a student has put in and taken out since. */
const char* cairn_scene_text(void);
/** From the scene's start once more, under the settings of now. */
int cairn_restart(void);

/** Gives a setting another value, in words: "10", "soft", "newton", "off". The world goes on as it is, where the setting
 *  allows it. The settings are those that cairn_settings() lists. */
int cairn_set(const char* setting, const char* value);
/** All settings as JSON: [{"name": "sweeps", "title": "Sweeps", "value": "10", "recommended": "10", "unit": "",
 *  "least": 0, "most": 100, "choices": [], "meanings": []}, ...]. Choices are the words that it takes; without any it
 *  takes numbers. Meanings say each of them in more words, where there are any. */
const char* cairn_settings(void);

/** So many steps, at most 100000, to the end of the one under way first; fewer where a body would then be at no finite
 *  place. Refuses once that is so. */
int cairn_step(int count);
/** The same, but after so many milliseconds no further step begins: cairn_numbers() tells how far it came. Each call takes
 *  one step at least. */
int cairn_step_for(int count, double milliseconds);
/** Whether the picture moves (1 or 0): then the ends of rows are sought only as far as a frame has time for. */
void cairn_move(int is_moving);
/** So many row updates on, within the first solve of the next step; past its end that step is done. */
int cairn_row(int count);
/** To the end of the sweep under way. */
int cairn_sweep(void);
/** Back to before the step under way, or before the last one, with the bodies and the settings of then: as far back as
 *  600 steps. */
int cairn_back(void);

/** Shows another of the steps that are kept, from cairn_numbers(); what comes after it stays until something is done. */
int cairn_visit(int step);
/** The step under way after so many of its row updates; 0: not begun. */
int cairn_visit_row(int updates);

/** A hand takes hold of the body at a point of the world [m], until it lets go; 0 where there is none that can move. */
int cairn_grab(double x, double y);
/** The hand pulls to another point [m]. */
int cairn_drag(double x, double y);
/** The hand lets go. */
void cairn_let_go(void);

/** Puts a box of this width and height [m] there. */
int cairn_add_box(double x, double y, double width, double height);
/** Puts a ball of this radius [m] there. */
int cairn_add_ball(double x, double y, double radius);
/** Puts walls on all sides of what the picture shows of the scene: one body, the newest. */
int cairn_add_walls(void);
/** Puts a rope of links between two points [m], pinned to a body at each; 0 is the ground. */
int cairn_add_rope(int body_a, double ax, double ay, int body_b, double bx, double by);
/** Takes a body out, with all that is fastened to it. */
int cairn_remove(int body);
/** Pins two bodies to each other at a point [m]; body 0 is the ground. */
int cairn_pin(int body_a, int body_b, double x, double y);
/** Takes the last of these changes back, and brings the world to where it was before it. */
int cairn_undo(void);

/** What a body is doing: x, y, angle, vx, vy, angular velocity, mass, and what can be done with it (0: it was removed;
 *  1: something can be pinned to it; 2: it can be taken hold of, too), for each body, the ground first. */
const double* cairn_bodies(void);
/** Their number. */
int cairn_body_count(void);
/** What a body did at each step that can be taken back, and now, the oldest first: time [s], height of its centre of mass
 *  [m], speed [m/s], angular velocity [rad/s]; NaN where it was not there. */
const double* cairn_body_history(int body);
/** What two bodies gave each other then by contacts and joints: time [s], size of the force [N], a mean over the step's last
 *  substep. */
const double* cairn_pair_history(int body_a, int body_b);
/** How many steps both have. */
int cairn_history_count(void);
/** What a body is called. */
const char* cairn_body_name(int body);

/** How far the body that was uppermost at the start has come down since [m], in the first world (0) or in that of the
 *  second solver (1); 0 where there is none. */
double cairn_fall(int world);

/** Of each row of the step under way, or else of the next one: its impulse now over the step, lambda [N] (or N m); where
 *  the sweeps would end if they went on; what the second solver gives; kind (0 joint, 1 normal, 2 friction); body a; body
 *  b. */
const double* cairn_rows(void);
/** Their number. */
int cairn_row_count(void);
/** Lights up a row and its two bodies; -1: none. */
void cairn_light_row(int row);
/** Where a student thinks that a row ends [N]. Its end is hidden until cairn_reveal(). */
int cairn_predict(int row, double newtons);
/** Shows where the predicted row ends. */
void cairn_reveal(void);

/** Numbers of now: time [s], steps done, rows, contact points, row updates done in the step under way, all of its row
 *  updates, its sweep, residual R_E left there, ms of the last step's computation, the row lit (-1: none), whether the
 *  world has diverged (1 or 0), steps that can be taken back, the row predicted (-1: none), its prediction [N], whether it
 *  is revealed, the last step that is kept, whether text and settings alone do not lead here (1 or 0). */
const double* cairn_numbers(void);
/** What has changed, in a sentence, for those who hear the page. */
const char* cairn_words(void);
/** What the scene requires, and what is left out and why: a line each. */
const char* cairn_plan(void);
/** 16 hexadecimal digits of all that the world is: the same on every machine. */
const char* cairn_fingerprint(void);

/** The size of the picture [px], at least 320 x 180, and how many pixels of the screen one of these is wide, 0.5 to 4. */
int cairn_resize(int width, int height, double scale);
/** Which picture: "light" or "dark". */
int cairn_theme(const char* theme);
/** What stands beside scene and bars: residuals and the equation of a row (1 or 0); and whether all rows have bars, those
 *  of friction, too (1), or contacts take one each between steps (0). */
int cairn_show(int has_panels, int all_rows);
/** How much of the last row update is drawn, from 0 to 1: a page that moves draws it several times. */
int cairn_moment(double share);
/** Draws the picture of now. In a browser: on the canvas with the id "cairn". */
int cairn_draw(void);
/** Shows the scene larger by a factor, around a place of the picture. */
int cairn_zoom(double factor, double x, double y);
/** Moves it by so many pixels. */
int cairn_pan(double x, double y);
/** Shows all of it, as after cairn_open(). */
void cairn_show_all(void);
/** What is at a place of the picture: kind (0 nothing, 1 the scene, 2 a row's bar), number (body, -1 for none; or row), x
 *  and y there (in m; on a bar x in N). */
const double* cairn_at(double x, double y);
/** Where a point of the scene is on the picture: x, y [px]. */
const double* cairn_place(double x, double y);

#ifdef __cplusplus
}
#endif

#endif
