# Files that are compiled by themselves wherever others share a batch. They instantiate World, or LaneSystem, again, for the
# members that they define; the last is the only one that reads toml++, whose headers are long.
set(CAIRN_ALONE world/world_state.cpp world/world_ahead.cpp world/world_contacts.cpp world/world_rows.cpp
    world/world_editing.cpp world/world_failures.cpp world/world_direct.cpp world/world_pins.cpp
    solvers/wide/lane_passes.cpp solvers/wide/lane_single_contacts.cpp scenes/scene_toml.cpp)
