// Looks at lcm-spy from within its own process (-javaagent): waits until its
// table names the type of a channel, opens the channel as a person would, reads
// the decoded fields from what it shows, and takes a picture of the screen.
import java.awt.Frame;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.lang.reflect.Field;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.swing.JTable;

public final class SpyProbe {
  private static final int LOOK_MS = 100;

  /** @param arguments CHANNEL,PICTURE.png */
  public static void premain(String arguments) {
    final String[] parts = arguments.split(",");
    final Thread thread = new Thread(() -> {
      int code = 1;
      try {
        probe(parts[0], new File(parts[1]));
        code = 0;
      } catch (Throwable e) {
        e.printStackTrace();
      }
      Runtime.getRuntime().halt(code);
    });
    thread.setDaemon(true);
    thread.start();
  }

  private static void probe(String channel, File picture) throws Exception {
    final JTable table = await(() -> find(Frame.getFrames(), JTable.class));
    await(() -> {
      final Integer row = rowOf(table, channel);
      return row != null
          && String.valueOf(table.getValueAt(row, 1)).contains("_t")
          ? true : null;
    });
    for (int r = 0; r < table.getRowCount(); ++r) {
      System.out.println("row " + table.getValueAt(r, 0) + " "
          + table.getValueAt(r, 1));
    }
    // Found again: a channel received since may have moved it.
    on(() -> {
      final Rectangle cell =
          table.getCellRect(rowOf(table, channel), 0, true);
      table.dispatchEvent(new MouseEvent(table, MouseEvent.MOUSE_CLICKED, 0, 0,
          cell.x + 3, cell.y + 3, 2, false, MouseEvent.BUTTON1));
      return null;
    });
    final Component panel = await(() -> find(Frame.getFrames(),
        Class.forName("lcm.spy.ObjectPanel").asSubclass(Component.class)));
    final Field shown = panel.getClass().getDeclaredField("o");
    shown.setAccessible(true);
    final Object message = await(() -> shown.get(panel));
    System.out.println("decoded " + message.getClass().getName());
    for (Field field : message.getClass().getFields()) {
      if (field.getType() == int.class || field.getType() == long.class) {
        System.out.println("field " + field.getName() + " "
            + field.get(message));
      }
    }
    on(() -> {
      Frame.getFrames()[0].setBounds(0, 0, 620, 760);
      final Frame viewer = Frame.getFrames()[Frame.getFrames().length - 1];
      viewer.setBounds(630, 0, 640, 760);
      return null;
    });
    final Rectangle screen =
        new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
    final Robot robot = new Robot();
    final BufferedImage painted = await(() -> {
      final BufferedImage image = robot.createScreenCapture(screen);
      return isPainted(image) ? image : null;
    });
    ImageIO.write(painted, "png", picture);
  }

  // Whether the windows cover most of the screen, which is black without them.
  private static boolean isPainted(BufferedImage image) {
    long black = 0;
    for (int y = 0; y < image.getHeight(); ++y) {
      for (int x = 0; x < image.getWidth(); ++x) {
        if ((image.getRGB(x, y) & 0xffffff) == 0) ++black;
      }
    }
    return 5 * black < (long) image.getWidth() * image.getHeight();
  }

  private static Integer rowOf(JTable table, String channel) {
    for (int r = 0; r < table.getRowCount(); ++r) {
      if (channel.equals(table.getValueAt(r, 0))) return r;
    }
    return null;
  }

  private static <T extends Component> T find(Component[] in, Class<T> type) {
    for (Component component : in) {
      if (type.isInstance(component) && component.isShowing()) {
        return type.cast(component);
      }
      if (!(component instanceof Container)) continue;
      final T found = find(((Container) component).getComponents(), type);
      if (found != null) return found;
    }
    return null;
  }

  // On the thread of the windows.
  private static <T> T on(Callable<T> task) throws Exception {
    final FutureTask<T> future = new FutureTask<>(task);
    EventQueue.invokeLater(future);
    return future.get();
  }

  // Until there is something; the test's own limit ends a wait in vain.
  private static <T> T await(Callable<T> look) throws Exception {
    while (true) {
      final T found = on(look);
      if (found != null) return found;
      Thread.sleep(LOOK_MS);
    }
  }
}
