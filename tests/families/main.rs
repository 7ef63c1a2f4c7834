//! Families of mechanisms with known answers: rounded files, unlike mechanisms beside one another, loops drawn open,
//! sizes from far too small to far too large.

mod drawn_open;
mod first_poses;
mod gazebo_joints;
mod independent_groups;
mod rigid;
mod rounded_files;
mod tiny_and_huge;
mod turned_lines;
