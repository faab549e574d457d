# Files that are compiled by themselves wherever others share a batch. They instantiate a class again, for the members that
# they define; the last is the only one that reads toml++, whose headers are long.
set(CAIRN_ALONE world/world_state.cpp world/world_editing.cpp world/contact_cache_pairs.cpp
    world/contact_finder_ahead.cpp world/contact_finder_sides.cpp solvers/exact/island_newton_interior.cpp solvers/wide/lane_passes.cpp
    scenes/scene_toml.cpp)
