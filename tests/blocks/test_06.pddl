(define (problem test-06)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 - block)
  (:init
    (hand-empty) (on-table b4) (on-table b2) (on-table b6) (on-table b3)
    (clear b5) (clear b1) (clear b6) (clear b3) (on b5 b4) (on b1 b2))
  (:goal (and
    (on b5 b2) (on b1 b5) (on b3 b6))))
